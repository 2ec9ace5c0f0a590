// Quads and derivatives: four pixels at a time, texture reads and their levels.

import { h, svg, table, value, vec } from "page/element.js";
import { state } from "page/state.js";

function quad_table(draw, of, x, y) {
    let at = 0;
    const pixels = [0, 1, 2, 3].map((i) => [(x & ~1) + i % 2, (y & ~1) + (i >> 1)]);
    const head = ["varying", ...pixels.map(([px, py], i) => [`${px}, ${py}`, h("br"), h("span", { class: "note" }, of.mask >> i & 1 ? (px === x && py === y ? "\u25c6 this pixel" : "\u25cf covered") : "\u25cb helper")]),
                  "right \u2212 left", "below \u2212 above"];
    const rows = draw.varyings.flatMap((varying) => Array.from({ length: varying.components }, (_, c) => {
        const k = at++, v = of.quad[k];
        return [`${varying.name}.${"xyzw"[c]}`, ...v.map((one, i) => value(one, `interpolate.quad.${k}.${i}`)),
                value(of.differences[k][0], `interpolate.differences.${k}.0`), value(of.differences[k][1], `interpolate.differences.${k}.1`)];
    }));
    return table(head, rows);
}

// The texels of one read, where they lie beside each other.
function texels(read, k) {
    const inside = read.texels.filter((texel) => texel.x >= 0);
    if (!inside.length)
        return "";
    const levels = [...new Set(inside.map((texel) => texel.level))];
    return levels.map((level) => {
        const own = inside.filter((texel) => texel.level === level);
        const left = Math.min(...own.map((t) => t.x)), top = Math.min(...own.map((t) => t.y));
        const byte = (v) => Math.round(255 * Math.min(1, Math.max(0, v)));
        const near = own.every((t) => t.x - left < 4 && t.y - top < 4);
        return near ? svg("svg", { viewBox: "-.05 -.05 2.6 2.6", width: 150, role: "img", "aria-label": `Texels of level ${level}` }, own.map((t) => [
            svg("rect", { x: (t.x - left) * 1.2, y: (t.y - top) * 1.2, width: 1.15, height: 1.15, fill: `rgb(${byte(t.value[0])} ${byte(t.value[1])} ${byte(t.value[2])})`, stroke: "var(--soft)", "stroke-width": .03 }),
            svg("rect", { x: (t.x - left) * 1.2 + .05, y: (t.y - top) * 1.2 + .8, width: 1.05, height: .3, fill: "var(--sheet)", opacity: .85 }),
            svg("text", { x: (t.x - left) * 1.2 + .1, y: (t.y - top) * 1.2 + 1.03, style: "font-size: .24px" }, `${(100 * t.weight).toFixed(1)} %`)])) : "";
    });
}

function read_of(draw, read, k) {
    const texture = draw.textures.find((one) => one.slot === read.slot);
    return [h("h3", {}, `Read ${k + 1}: slot ${read.slot}, ${read.surface || texture?.name || "no texture"}`),
            h("p", {}, "at ", vec(read.coord, `texture.${k}.coord`), ", level of detail ", value(read.lod, `texture.${k}.lod`),
              read.magnified ? ", magnified" : ", minified", ", gives ", vec(read.result, `texture.${k}.result`)),
            h("div", { class: "cols" },
              table(["texel", "level", "weight", "value"], read.texels.map((texel, i) => [
                  texel.x < 0 ? "border" : h("span", { class: "v" }, `${texel.x}, ${texel.y}`), value(texel.level, `texture.${k}.texels.${i}.level`),
                  value(texel.weight, `texture.${k}.texels.${i}.weight`), vec(texel.value, `texture.${k}.texels.${i}.value`)])),
              h("div", {}, texels(read, k)))];
}

export const quads = {
    id: "quads", title: "Quads, textures", tab: "Quads", needs: "pixel", source: "pipeline/units/texture.c", rules: "R40 to R49",
    says: ["Pixels are shaded four at a time, two by two, so that differences between neighbours exist: these are the derivatives.",
           "Pixels of the four that the triangle does not cover are helpers: shaded, and thrown away.",
           "From the differences of a coordinate follows how many texels a pixel spans, and so the level of the texture that is read."],
    formula: "dsx = right \u2212 left,  dsy = lower \u2212 upper\n\u03c1 = max(|(du/dx W, dv/dx H)|, |(du/dy W, dv/dy H)|)\nlevel = log\u2082 \u03c1 + bias",
    make: ({ draw, one }) => h("div", {},
        h("h3", {}, "The quad"),
        one.interpolate.quad.length ? quad_table(draw, one.interpolate, state.x, state.y) : h("p", {}, "No varyings."),
        one.textures.length ? one.textures.map((read, k) => read_of(draw, read, k)) : h("p", {}, "The pixel shader reads no texture here.")),
};
