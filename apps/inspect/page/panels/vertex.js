// The vertex shader: what went in, and what came out.

import { h, swatch, table, value, vec } from "page/element.js";
import { inputs_of } from "page/panels/assembly.js";

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
    make: ({ draw, primitive, frame }) => h("div", {},
        primitive.vertices.map((one, i) => [
            h("h3", {}, `v${i}: vertex ${one.vertex}`),
            table(["", "in"], inputs_of(draw, one, `vertices.${i}`).map((cell, k) => [draw.inputs[k].name, cell])),
            table(["", "out", ""], [["clip position", vec(one.clip, `vertices.${i}.clip`), "x, y, z, w"],
                                    ...varyings_of(draw, one.varyings, `vertices.${i}.varyings`)])]),
        draw.vertex_shader ? h("p", { class: "note" }, `${draw.vertex_shader.slots} slots, ${draw.vertex_shader.temporaries} registers, ${draw.vertex_shader.constants} constants; ${draw.vertex_shader.profile}`) : "",
        frame.programs[draw.program] ? h("p", { class: "note" }, "The program is ", h("code", {}, frame.programs[draw.program]), ": its text is beside the pixel shader's steps.") : ""),
};
