// Voxelization: targets whose texels are worksheets, columns of voxels with a bit each.

import { h, table } from "page/element.js";
import { state } from "page/state.js";

const names = ["red", "green", "blue", "alpha"];

// The bits of a channel of eight, the highest first.
function bits(code) {
    return code.toString(2).padStart(8, "0");
}

export const voxels = {
    id: "voxels", title: "Voxels", needs: "draw", source: "shaders_c/voxel/methods/sheets.c",
    says: ["A voxel column of the volume is a pixel; its voxels are bits, 32 in a texel of four channels.",
           "A triangle sets the bits that it passes, by blending: each fragment adds or toggles its own.",
           "Below are the worksheets of this column, as they are after this draw."],
    applies: ({ frame }) => frame.technique === "voxelize",
    make: async ({ frame, pass, draw }) => {
        const rows = [];
        for (const target of pass.targets) {
            const surface = frame.surfaces[target.surface];
            if (surface.format !== "A8R8G8B8" || state.x >= surface.width || state.y >= surface.height)
                continue;
            const image = await frame.targets.after(target.surface, frame.stop_of(state.pass, draw?.draw ?? 0));
            const codes = image.at(state.x, state.y).map((value) => Math.round(255 * value));
            rows.push([`target ${target.slot}`, ...codes.map((code) => h("code", {}, bits(code)))]);
        }
        return h("div", {}, h("p", {}, `Column ${state.x}, ${state.y} of pass ${state.pass}:`),
                 rows.length ? table(["sheet", ...names], rows) : h("p", {}, "This pass has no sheet of bits: choose another in the list of the frame."));
    },
};
