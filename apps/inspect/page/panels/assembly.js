// Input assembly: which vertices make the primitive, and what their streams hold.

import { h, table, value, vec } from "page/element.js";

// The vertex's inputs, one after the other, cut as the program declares them.
export function inputs_of(draw, vertex, path) {
    let at = 0;
    return draw.inputs.map((input) => {
        const from = at;
        at += input.components;
        return vertex.inputs.slice(from, at).length ? h("span", { class: "vec" }, "(", vertex.inputs.slice(from, at).map(
            (one, i) => [i ? ", " : "", value(one, `${path}.inputs.${from + i}`)]), ")") : "";
    });
}

const forms = {
    "triangles": ["3i, 3i + 1, 3i + 2", (i) => [3 * i, 3 * i + 1, 3 * i + 2]],
    "points": ["i", (i) => [i]],
    "triangle strip": ["i, i + 1, i + 2; where i is odd i, i + 2, i + 1", (i) => i % 2 ? [i, i + 2, i + 1] : [i, i + 1, i + 2]],
    "triangle fan": ["i + 1, i + 2, 0", (i) => [i + 1, i + 2, 0]],
};

export const assembly = {
    id: "assembly", title: "Input assembly", tab: "Assembly", needs: "primitive", source: "pipeline/units/input_assembly.c",
    rules: "R25 and \u201cGeometry\u201d",
    says: ["Input assembly takes the elements of a primitive, finds the vertices that they name, and reads each vertex's streams.",
           "What is stored as bytes or halves becomes floats; components that a stream lacks read as (0, 0, 0, 1).",
           "A vertex that several triangles name is shaded once: that is what indices are for."],
    formula: "vertex k = index[element]\ncomponent = code / (2\u207f \u2212 1)   of unorm\ncomponent = max(code / (2\u207f\u207b\u00b9 \u2212 1), \u22121)   of snorm",
    make: ({ draw, primitive, fragment }) => {
        const [words, of] = forms[draw.geometry] ?? ["", () => []], elements = of(fragment.primitive);
        return h("div", {},
            h("p", {}, `${draw.geometry[0].toUpperCase() + draw.geometry.slice(1)} ${fragment.primitive}: elements ${words}, here `, h("span", { class: "v" }, elements.join(", ")),
              draw.indexed ? `, looked up in ${draw.elements} indices.` : ", which are the vertices themselves."),
            table(["corner", "element", "vertex", ...draw.inputs.map((input) => input.name)], primitive.vertices.map((vertex, i) => [
                `v${i}`, String(elements[i] ?? ""), value(vertex.vertex, `vertices.${i}.vertex`), ...inputs_of(draw, vertex, `vertices.${i}`)])),
            h("h3", {}, "As stored"),
            table(["input", "type", "components", "stride", ...primitive.vertices.map((_, i) => `bytes of v${i}`)], draw.inputs.map((input, k) => [
                input.name, input.type, `${input.stored} of ${input.components}`, `${input.stride || "packed"}`,
                ...primitive.vertices.map((vertex) => h("code", {}, vertex.raw?.[k] ?? ""))])),
            h("p", { class: "note" }, "Of this draw's elements name ", primitive.vertices.map((vertex, i) => [i ? ", " : "", `v${i}: ${vertex.reuse}`]), "."));
    },
};
