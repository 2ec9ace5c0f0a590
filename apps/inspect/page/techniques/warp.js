// Depth images: which image and texel a pixel came from, how deep it was there, and what lay about it.

import { h, svg, table, value, vec } from "page/element.js";
import { inputs_of } from "page/panels/assembly.js";
import { listing_of, watched } from "page/steps.js";
import { draws_with, gaps, go_to, is_chosen, fate_cell, numbers, source_of, story } from "page/techniques/story.js";

// The texel of a read that counts most.
function main_texel(read) {
    return read.texels.filter((texel) => texel.x >= 0).toSorted((a, b) => b.weight - a.weight)[0];
}

function texel_picture(read) {
    const inside = read.texels.filter((t) => t.x >= 0), left = Math.min(...inside.map((t) => t.x)), top = Math.min(...inside.map((t) => t.y));
    if (!inside.length || inside.some((t) => t.x - left > 3 || t.y - top > 3 || t.level !== inside[0].level))
        return "";
    const byte = (v) => Math.round(255 * Math.min(1, Math.max(0, v)));
    return svg("svg", { viewBox: "-.05 -.05 2.6 2.6", width: 120, role: "img", "aria-label": "Texels of the image" }, inside.map((t) => [
        svg("rect", { x: (t.x - left) * 1.2, y: (t.y - top) * 1.2, width: 1.15, height: 1.15, fill: `rgb(${byte(t.value[0])} ${byte(t.value[1])} ${byte(t.value[2])})`, stroke: "var(--soft)", "stroke-width": .03 }),
        svg("rect", { x: (t.x - left) * 1.2 + .05, y: (t.y - top) * 1.2 + .8, width: 1.05, height: .3, fill: "var(--sheet)", opacity: .85 }),
        svg("text", { x: (t.x - left) * 1.2 + .1, y: (t.y - top) * 1.2 + 1.03, style: "font-size: .24px" }, `${(100 * t.weight).toFixed(1)} %`)]));
}

function read_of(one, read, k) {
    const texel = main_texel(read), texture = one.draw_of.textures.find((of) => of.slot === read.slot);
    return [read.slot === 0 ? "colour" : `slot ${read.slot}`, `${read.surface || texture?.name || "picture"}, ${texture?.width} \u00d7 ${texture?.height}`,
            texel ? [h("span", { class: "v" }, `${texel.x}, ${texel.y}`), texel.level ? h("span", { class: "note" }, ` of level ${texel.level}`) : ""] : "border", vec(read.coord.slice(0, 2), `${one.path}.texture.${k}.coord`), vec(read.result, `${one.path}.texture.${k}.result`), texel_picture(read)];
}

// The corners of the triangle are pixels of the image: where they lie there, and how deep.
async function corners_of(frame, pass, one) {
    const primitive = await frame.primitive(pass.pass, one.draw, one.primitive), { inputs } = one.draw_of;
    if (!primitive)
        return "";
    return [h("h3", {}, "The corners: places of the image"), table(["corner", ...inputs.map((input) => input.name === "position" ? "place and flat depth" : input.name), "clip position"], primitive.vertices.map((vertex, i) => [
                `v${i}: ${vertex.vertex}`, ...inputs_of(one.draw_of, vertex, `${one.path}.vertices.${i}`), vec(vertex.clip, `${one.path}.vertices.${i}.clip`)])),
            h("p", { class: "note" }, "A flat depth is 1 / depth where the image's rays meet in an eye, and depth itself where they are parallel: of a plane it is linear in the picture, so it is what is interpolated, and what the test of jumps compares. Corners whose flat depths jump further than the surfaces on both sides are steep are never joined: this triangle's three are one surface.")];
}

// A search along the ray: its turns.
function search(listing, one) {
    const turns = [], last = {};
    for (const watch of watched(listing, one.steps)) {
        if (watch.name === "at")
            turns.push({});
        const place = ["at", "behind", "deep"].includes(watch.name) && turns.length ? turns.at(-1) : last;
        place[watch.name] = numbers(watch.of, (c) => `${one.path}.${watch.path(c)}`);
    }
    return [last.t ? h("p", {}, "The ray meets the surface at ", last.t, " of its way through the box, at ", last.place, ".") : "",
            turns.length ? [h("h3", {}, "The search along the ray"), table(["turn", "texel x, y and depth", "behind the surface by", "behind the nearest of four by"], turns.map((turn, i) => [String(i), turn.at, turn.behind ?? "", turn.deep ?? ""]))] : ""];
}

async function detail(frame, pass, one) {
    const listing = await listing_of(pass, one.steps);
    return [h("h3", {}, `Draw ${one.draw}, ${one.draw_of.program.replace(/_program$/, "")}: triangle ${one.primitive}`),
            one.textures.length ? table(["read", "image", "texel", "coordinate", "gives", ""], one.textures.slice(0, 8).map((read, k) => read_of(one, read, k))) : "",
            search(listing, one), one.draw_of.primitives > 2 ? await corners_of(frame, pass, one) : ""];
}

export const warp = {
    id: "warp", title: "Depth image", needs: "draw", source: (context) => source_of(context, "warp", "shaders_c/warp/direct.c"), rules: "R16, R18, R40 to R45",
    says: ["A depth image knows of each of its pixels how far away it was: so it can be seen from elsewhere, as a surface through its pixels.",
           "What is near moves further aside than what is far; where depth jumps from one pixel to the next, there is no surface between, and the picture has a hole behind what is near.",
           "Methods differ in what they draw: triangles between pixels, a search along each ray, or parts moved within the picture."],
    formula: "place  = spread(depth) \u00b7 (u, v)\nflat   = 1 / depth   (rays of an eye),  depth (parallel)\njoined where |flat\u1d62 \u2212 flat\u2c7c| is no steeper than both sides",
    applies: ({ frame }) => draws_with(frame, "warp"),
    make: async (context) => {
        const { frame } = context, all = await story(frame, "shaders_c/warp/");
        const found = all.flatMap(({ pass, fragments }) => fragments.map((one) => ({ pass, one })));
        const chosen = found.find(({ pass, one }) => is_chosen(context, pass, one)) ?? found.findLast(({ one }) => one.outputs.length) ?? found.at(-1);
        if (!chosen)
            return h("div", {}, gaps(all), h("p", {}, "No depth image covers this pixel."));
        return h("div", {}, gaps(all), table(["pass", "layer: draw/triangle", "depth", ""], found.map(({ pass, one }) => ({ properties: { class: one === chosen.one && "now" }, cells: [
                     `${pass.pass}, ${pass.name}`, go_to(frame, pass, one, `${one.draw}/${one.primitive}`), one.pixel ? value(one.pixel.depth, `${one.path}.pixel.depth`) : "", fate_cell(one)] }))),
                 await detail(frame, chosen.pass, chosen.one));
    },
};
