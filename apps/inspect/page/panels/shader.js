// The pixel shader, instruction by instruction, as a debugger steps.

import { h, swatch, table, vec } from "page/element.js";
import { state } from "page/state.js";
import { debugger_of } from "page/steps.js";

export const shader = {
    id: "shader", title: "Pixel shader", needs: "pixel", source: "pipeline/units/pixel_stage.c", rules: "\u201cInstructions\u201d, R50 to R52",
    says: ["The pixel shader is a list of instructions on four-component registers; it has no branches that differ from pixel to pixel.",
           "Every step is the shader's own source, run again with recording lanes: what comes out has the bits that were drawn.",
           "Slots are what an instruction cost in the hardware of the time; registers are named after the step that wrote them."],
    formula: "r\u2099 = instruction(operands)\ncolour = what the last ones leave",
    make: async (context) => {
        const { draw, one } = context;
        if (!one.pixel)
            return h("p", {}, "This draw leaves its pixel shader out: nothing that it computes is kept.");
        const gives = table(["target", "colour that the shader gives"], one.pixel.color.map((of, i) => [String(i), [swatch(of), vec(of, `pixel.color.${i}`)]]));
        if (!one.steps)
            return h("div", {}, gives, h("p", { class: "note" }, "This program was built without its counting lanes, which record steps."));
        const own = { inputs: one.interpolate.varyings, place: [state.x, state.y], face: one.raster.front ? 1 : -1 };
        return h("div", {}, one.pixel.killed ? h("p", { class: "callout" }, h("b", { class: "bad" }, "It kills this fragment.")) : "", gives,
                 await debugger_of(context, one.steps, draw.varyings, own, "steps", "pixel"));
    },
};
