// Blending and output: what becomes of the colour that the shader gave.

import { h, swatch, table, value } from "page/element.js";

const names = ["red", "green", "blue", "alpha"];

function of_target(output, i, draw) {
    const { blend } = output, off = blend.op === "off", path = `output.${i}`;
    const rows = names.map((name, c) => [name,
        value(output.source[c], `${path}.source.${c}`),
        off ? "" : ["\u00d7 ", value(output.source_factor[c], `${path}.source_factor.${c}`)],
        off ? "" : value(output.destination[c], `${path}.destination.${c}`),
        off ? "" : ["\u00d7 ", value(output.destination_factor[c], `${path}.destination_factor.${c}`)],
        value(output.blended[c], `${path}.blended.${c}`),
        blend.keep >> c & 1 ? h("span", { class: "note" }, "masked: kept") : value(output.result[c], `${path}.result.${c}`)]);
    return [h("h3", {}, `Target ${output.target}, ${output.format}: ${off ? "replaced" : `${blend.op}, source \u00d7 ${blend.src}, target \u00d7 ${blend.dst}`}`),
            h("p", {}, "source ", swatch(output.source), off ? "" : ["  target before ", swatch(output.destination)], "  stored ", swatch(output.result)),
            table(["", "source", "factor", "target before", "factor", "exact result", "stored, read back"], rows)];
}

export const blending = {
    id: "blending", title: "Blending, output", tab: "Output", needs: "pixel", source: "pipeline/units/blend.c", rules: "R24, R30 to R37",
    says: ["Blending weighs the shader's colour, the source, against what the target holds, each by a factor, channel by channel.",
           "Where it is off, the source replaces; what the write mask takes out keeps its bits.",
           "The result is then rounded to the target's format: what is read back is what later draws, and you, will see."],
    formula: "result = source \u00d7 factor\u209b + target \u00d7 factor\u209c\ncode   = truncate(clamp(result) \u00d7 255 + \u00bd)",
    make: ({ one, fragment, frame }) => one.outputs.length ? h("div", {}, one.outputs.map((output, i) => of_target(output, i)))
        : h("p", {}, fragment.verdict > 1 ? `Nothing is written: ${frame.verdicts[fragment.verdict]}.` : "This draw writes no colour; what it leaves is depth or stencil."),
};
