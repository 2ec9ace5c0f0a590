// The vertex shader: what went in, and what came out.

import { h, swatch, table, value, vec } from "page/element.js";
import { inputs_of } from "page/panels/assembly.js";
import { choose, state } from "page/state.js";
import { debugger_of } from "page/steps.js";

/** A vertex's, or a pixel's, varyings, cut as the program declares them: [[name, element], ...]. */
export function varyings_of(draw, values, path) {
    let at = 0;
    return draw.varyings.map((varying) => {
        const from = at;
        at += varying.components;
        const own = values.slice(from, at);
        return [varying.name, h("span", { class: "vec" }, varying.name.includes("color") && own.length > 2 ? swatch(own) : "", "(",
                                own.map((one, i) => [i ? ", " : "", value(one, `${path}.${from + i}`)]), ")"), varying.mode];
    });
}

export const vertex = {
    id: "vertex", title: "Vertex shader", needs: "primitive", source: "pipeline/units/vertex_stage.c", rules: "\u201cSpaces\u201d, \u201cInstructions\u201d",
    says: ["The vertex shader makes of each vertex's inputs a position in clip space, and varyings that the pixels will share.",
           "It sees one vertex at a time: nothing of the triangle, nothing of the screen.",
           "In clip space a point is inside where \u2212w \u2264 x \u2264 w, \u2212w \u2264 y \u2264 w and 0 \u2264 z \u2264 w; w is its distance along the view in most programs."],
    formula: "(x, y, z, w) = M (position, 1)\ninside: 0 \u2264 z \u2264 w",
    make: async (context) => {
        const { draw, primitive } = context, corners = primitive.vertices, corner = Math.min(state.corner, corners.length - 1);
        const one = corners[corner], path = `vertices.${corner}`, costs = draw.vertex_shader;
        const inputs = corners.map((vertex, i) => inputs_of(draw, vertex, `vertices.${i}`));
        const outputs = corners.map((vertex, i) => varyings_of(draw, vertex.varyings, `vertices.${i}.varyings`));
        const names = corners.map((vertex, i) => `v${i}: vertex ${vertex.vertex}`);
        return h("div", {},
            table(["in", ...names], draw.inputs.map((input, k) => [input.name, ...inputs.map((of) => of[k])])),
            table(["out", ...names, ""], [["clip position", ...corners.map((vertex, i) => vec(vertex.clip, `vertices.${i}.clip`)), "x, y, z, w"],
                                          ...(outputs[0] ?? []).map((row, k) => [row[0], ...outputs.map((of) => of[k][1]), row[2]])]),
            h("h3", {}, "Step by step"),
            corners.length > 1 ? h("div", { class: "bar", role: "group", "aria-label": "Corner of the triangle" }, names.map((name, i) => h("button", { type: "button", "aria-pressed": String(i === corner), onclick: () => choose({ corner: i, step: 0 }) }, name))) : "",
            one.steps ? await debugger_of(context, one.steps, draw.inputs, { inputs: one.inputs }, `${path}.steps`, "vertex")
                : h("p", { class: "note" }, "The steps of this vertex are not in the page."),
            costs ? h("p", { class: "note" }, `${costs.slots} slots, ${costs.temporaries} registers, ${costs.constants} constants; ${costs.profile}`) : "");
    },
};
