// Voxelization: targets whose texels are worksheets, columns of voxels with a bit each.

import { h, table } from "page/element.js";
import { choose, state } from "page/state.js";
import { draws_with, source_of } from "page/techniques/story.js";

const names = ["red", "green", "blue", "alpha"], places = [2, 1, 0, 3]; // of a channel's byte in A8R8G8B8
const widest = 256;

function bits(code) {
    return [...code.toString(2).padStart(8, "0")];
}

// One bit of every texel as a picture, and where the column stands in it.
function slice(image, channel, bit) {
    const { width, height, bytes } = image.surface, canvas = h("canvas", { width, height, role: "img", "aria-label": `Bit ${bit} of ${names[channel]}` });
    const data = new ImageData(width, height);
    let set = 0;
    for (let i = 0; i < width * height; i++) {
        const on = image.bytes[i * bytes + places[channel]] >> bit & 1;
        set += on;
        data.data.set(on ? [25, 60, 130, 255] : [232, 236, 242, 255], 4 * i);
    }
    canvas.getContext("2d").putImageData(data, 0, 0);
    const here = image.bytes[(state.y * width + state.x) * bytes + places[channel]] >> bit & 1;
    const go = (event) => {
        const box = canvas.getBoundingClientRect();
        choose({ x: Math.floor((event.clientX - box.left) / box.width * width), y: Math.floor((event.clientY - box.top) / box.height * height), fragment: -1 });
    };
    canvas.addEventListener("click", go);
    return [set, h("figure", { class: here ? "slice on" : "slice" }, h("div", { class: "place" }, canvas,
                     h("span", { class: "dot", style: `left: ${100 * (state.x + .5) / width}%; top: ${100 * (state.y + .5) / height}%` })),
                   h("figcaption", {}, `${names[channel]} ${bit}: ${here ? "\u25cf set" : "\u25cb not"}`))];
}

function slices_of(image) {
    const made = names.flatMap((_, channel) => [0, 1, 2, 3, 4, 5, 6, 7].map((bit) => slice(image, channel, bit)));
    const empty = made.filter(([set]) => set === 0).length;
    return [h("div", { class: "slices" }, made.filter(([set]) => set > 0).map(([, figure]) => figure)),
            empty ? h("p", { class: "note" }, `${empty} slices have no voxel, and are left out.`) : ""];
}

async function sheet(frame, pass, draw, target) {
    const surface = frame.surfaces[target.surface];
    const image = await frame.targets.after(target.surface, frame.stop_of(state.pass, draw?.draw ?? 0));
    const at = (state.y * surface.width + state.x) * surface.bytes;
    return [h("h3", {}, `Worksheet ${target.slot}: 32 voxels of each column`),
            table(["", ...names], [[`column ${state.x}, ${state.y}`, ...places.map((place) => h("code", {}, bits(image.bytes[at + place]).map((bit) => bit === "1" ? h("b", { class: "good" }, "1") : "0")))],
                                   ["", ...names.map(() => h("span", { class: "note" }, "bit 7 \u2026 0"))]]),
            surface.width <= widest && surface.height <= widest ? [h("p", {}, "Each bit is a slice of the volume, seen from where the columns begin; the ring is this column, and a click chooses another."), slices_of(image)] : ""];
}

export const voxels = {
    id: "voxels", title: "Voxels", needs: "draw", source: (context) => source_of(context, "voxel", "shaders_c/voxel/methods/sheets.c"), rules: "R5 to R9, R24, R30 to R37",
    says: ["A column of the volume is a pixel; its voxels are bits, eight in a channel, 32 in a texel.",
           "A triangle sets the bits that it passes, by blending: each fragment adds or toggles its own.",
           "Below are the worksheets of this column, as they are after this draw; each bit over all columns is a slice of the volume."],
    formula: "voxel z of column (x, y) = bit (z mod 8) of channel (z / 8) mod 4\nsurface: code OR bits        solid: code XOR bits below",
    applies: ({ frame }) => draws_with(frame, "voxel"),
    make: async ({ frame, pass, draw }) => {
        const sheets = pass.targets.filter((target) => {
            const surface = frame.surfaces[target.surface];
            return surface.format === "A8R8G8B8" && target.surface !== frame.picture && state.x < surface.width && state.y < surface.height;
        });
        return h("div", {}, sheets.length ? await Promise.all(sheets.map((target) => sheet(frame, pass, draw, target)))
            : h("p", {}, "This pass has no sheet of bits: choose another in the list of the frame."));
    },
};
