// Shadow mapping: the map's texels that were compared, with their weights, beside what was compared with them.

import { h, svg, table, value, vec } from "page/element.js";
import { against_truth } from "page/pixel.js";

function is_map(read, { draw, frame }) {
    return read.compares || ((frame.technique === "shadow" || frame.programs[draw.program]?.startsWith("shaders_c/shadow/")) && (/^D(16|24|32)/.test(read.format ?? "") || /(32|16)F$/.test(read.format ?? "")));
}

// The texels about the place that was asked for: dark where something nearer to the light is stored.
function picture(read) {
    const inside = read.texels.filter((texel) => texel.x >= 0);
    if (!inside.length)
        return "";
    const left = Math.min(...inside.map((t) => t.x)), top = Math.min(...inside.map((t) => t.y));
    const wide = Math.max(...inside.map((t) => t.x)) - left + 1, high = Math.max(...inside.map((t) => t.y)) - top + 1;
    if (wide > 4 || high > 4)
        return "";
    return svg("svg", { viewBox: `-.05 -.05 ${wide * 1.2} ${high * 1.2}`, width: 90 * wide, role: "img", "aria-label": "Texels of the map" }, inside.map((t) => {
        const lit = t.passes;
        return [svg("rect", { x: (t.x - left) * 1.2, y: (t.y - top) * 1.2, width: 1.15, height: 1.15, fill: lit ? "var(--tint)" : "var(--ink)", stroke: "var(--soft)", "stroke-width": .02 }),
                svg("text", { x: (t.x - left) * 1.2 + .1, y: (t.y - top) * 1.2 + .4, style: `font-size: .22px; fill: ${lit ? "var(--ink)" : "var(--ground)"}` }, lit ? "\u25cb lit" : "\u25cf dark"),
                svg("text", { x: (t.x - left) * 1.2 + .1, y: (t.y - top) * 1.2 + .75, style: `font-size: .18px; fill: ${lit ? "var(--ink)" : "var(--ground)"}` }, `${(100 * t.weight).toFixed(1)} %`)];
    }));
}

// The shader compares by itself: what it compares with is among its steps.
function of_plain_read(read, k, texture) {
    return [h("h3", {}, `Read of ${read.surface || texture?.name || "the map"}, ${texture?.width} \u00d7 ${texture?.height}, ${read.format}`),
            h("p", {}, "at ", vec(read.coord.slice(0, 2), `texture.${k}.coord`), " gives ", vec(read.result, `texture.${k}.result`), ", which the shader compares: see its steps."),
            table(["texel", "weight", "stored"], read.texels.map((texel, i) => [texel.x < 0 ? "border" : h("span", { class: "v" }, `${texel.x}, ${texel.y}`),
                value(texel.weight, `texture.${k}.texels.${i}.weight`), vec(texel.value, `texture.${k}.texels.${i}.value`)]))];
}

function of_read(read, k, draw) {
    const texture = draw.textures.find((one) => one.slot === read.slot), reference = read.coord[2];
    if (!read.compares)
        return of_plain_read(read, k, texture);
    return [h("h3", {}, `Read of ${read.surface || texture?.name || "the map"}, ${texture?.width} \u00d7 ${texture?.height}, ${read.format}`),
            h("p", {}, "The point is at ", vec(read.coord.slice(0, 2), `texture.${k}.coord`), " of the map, its distance, bias included, is ", value(reference, `texture.${k}.coord.2`),
              "; the sampler compares it with each texel and weighs the verdicts: ", vec(read.result, `texture.${k}.result`)),
            h("div", { class: "cols" },
              table(["texel", "weight", "stored depth", "stored \u2212 the point's", "verdict"], read.texels.map((texel, i) => [
                  texel.x < 0 ? "border" : h("span", { class: "v" }, `${texel.x}, ${texel.y}`), value(texel.weight, `texture.${k}.texels.${i}.weight`),
                  value(texel.value[0], `texture.${k}.texels.${i}.value.0`), value(texel.ahead, `texture.${k}.texels.${i}.ahead`),
                  texel.passes ? h("span", { class: "good" }, "\u25cb lit") : h("span", { class: "bad" }, "\u25cf in shadow")])),
              h("div", {}, picture(read)))];
}

// What a ray from here to the light says.
async function truth_of(frame) {
    const said = await against_truth(frame);
    return said && [h("h3", {}, "The true verdict"), said, h("p", { class: "note" }, frame.truth.how)];
}

export const shadow = {
    id: "shadow", title: "Shadow map", needs: "pixel", source: "shaders_c/shadow/shadow.c", rules: "R17, R21, R40, R49",
    says: ["A shadow map is the scene's depth as the light sees it; a point is in shadow where the map holds something nearer to the light.",
           "The map has texels, and a point lies between them: each texel is asked, and the verdicts are weighed.",
           "A bias moves the point towards the light before it is compared, so that a surface does not shade itself."],
    formula: "lit = \u03a3 weight\u1d62 (point + bias \u2264 stored\u1d62 ? 1 : 0)",
    applies: (context) => context.frame.technique === "shadow" || Boolean(context.draw && context.one?.textures.some((read) => is_map(read, context))),
    make: async (context) => {
        const reads = context.one.textures.map((read, k) => is_map(read, context) ? of_read(read, k, context.draw) : "");
        return h("div", {}, await truth_of(context.frame), reads.some(Boolean) ? reads : h("p", {}, "This draw asks no map here."));
    },
};
