// What a draw is: its state beside the draw before, the units that it needs, and how many came through.

import { count, h, num, table } from "page/element.js";

function text_of(of) {
    return Array.isArray(of) ? of.map(num).join(", ") : of === undefined ? "" : typeof of === "number" ? num(of) : of;
}

function states(pass, draw) {
    const before = pass.draws[draw.draw - 1], rows = [];
    for (const [key, now] of Object.entries(draw.state)) {
        const then = before?.state[key], changed = before && text_of(then) !== text_of(now);
        rows.push({ cells: [key, h(changed ? "b" : "span", {}, text_of(now)), changed ? [h("span", { class: "warn" }, "\u0394 "), "was ", text_of(then)] : ""],
                    properties: { class: changed && "now" } });
    }
    return [h("h3", {}, "State", before ? h("small", { class: "note" }, "  beside the draw before it: \u0394 marks what changed") : ""),
            table(["", "this draw", "the draw before"], rows)];
}

const words = {
    vertices: "vertices shaded", primitives: "triangles and points", drawn: "cover a pixel", fragments: "fragments",
    written: "written",
};
const losses = {
    primitives: [], drawn: [["outside", "outside the clip volume"], ["facing", "culled by facing"], ["zero_area", "of zero area"],
                            ["no_centre", "hold no pixel centre"]],
    written: [["clip_plane", "cut by a clip plane"], ["killed", "killed by the shader"], ["scissor", "scissor"], ["alpha", "alpha test"],
              ["stencil", "stencil test"], ["depth", "depth test"]],
};

function funnel(stop) {
    const rows = [], of = stop.counters;
    for (const key of ["vertices", "primitives", "drawn", "fragments", "written"]) {
        const most = ["fragments", "written"].includes(key) ? of.fragments : Math.max(of.vertices, of.primitives);
        rows.push(h("span", {}, words[key]),
                  h("span", { class: "track", "aria-hidden": "true" },
                    h("span", { class: "fill", style: `display: block; width: ${most ? 100 * of[key] / most : 0}%` })),
                  h("span", { class: "v", "data-counter": key }, count(of[key])));
        const lost = (losses[key] ?? []).filter(([name]) => of[name]);
        if (lost.length)
            rows.push(h("span", { class: "lost" }, lost.map(([name, text], i) => [i ? "; " : "less ", h("span", { class: "v", "data-counter": name }, count(of[name])), ` ${text}`])));
    }
    return [h("h3", {}, "What came through", stop.count > 1 ? h("small", { class: "note" }, `  of draws ${stop.first} to ${stop.first + stop.count - 1}`) : ""),
            h("div", { class: "funnel" }, rows),
            of.cut ? h("p", { class: "note" }, `${count(of.cut)} triangles were cut by a plane; each part that is left is set up by itself.`) : ""];
}

function uniforms(draw) {
    if (!draw.uniforms?.length)
        return "";
    return [h("h3", {}, "Uniforms"), table(["", "value"], draw.uniforms.map((one) => [
        one.name, h("span", { class: "v" }, Array.isArray(one.value[0])
            ? one.value.map((row, i) => [i ? h("br") : "", row.map(num).join("  ")]) : one.value.map(num).join(", "))]))];
}

function textures(draw) {
    if (!draw.textures.length)
        return "";
    return [h("h3", {}, "Textures"), table(["slot", "texture", "size", "filters", "address"], draw.textures.map((one) => [
        String(one.slot), `${one.name || "unnamed"}, ${one.format}`, `${one.width} \u00d7 ${one.height}, ${one.levels} level${one.levels > 1 ? "s" : ""}`,
        `min ${one.min}, mag ${one.mag}, mip ${one.mip}${one.compare ? ", compares depth" : ""}`, `${one.u}, ${one.v}`]))];
}

function times(frame) {
    if (!frame.timings)
        return "";
    const all = ["prepare", "vertices", "bins", "tiles"], of = frame.timings;
    return [h("h3", {}, "The whole frame's time"),
            h("p", { class: "note" }, `Fast executor, ${of.isa}, ${of.threads} thread${of.threads > 1 ? "s" : ""}; one run on one machine.`),
            table(["phase", "ms"], all.map((key) => [key, of[key].toFixed(2)]))];
}

export const draw = {
    id: "draw", title: "Draw", needs: "draw", source: "pipeline/list/needs.c",
    says: ["A draw is a program, a geometry, a state and textures; nothing is remembered from the draw before.",
           "From these alone follows which units have work: the others are left out, and nothing is lost by it.",
           "The targets above are shown as they are after this draw."],
    formula: "draw = program(uniforms, textures), geometry, state\nunit runs: some later one reads what it gives",
    rules: "\u201cPixels\u201d, \u201cGroups\u201d",
    make: ({ frame, pass, draw: of }) => {
        if (!of)
            return h("p", {}, "This pass has no draw: it clears.");
        const stop = pass.stops.find((one) => of.draw >= one.first && of.draw < one.first + one.count);
        return h("div", {}, h("p", {}, `${count(of.primitives)} ${of.geometry} of ${count(of.vertices)} vertices; program `, h("code", {}, of.program),
                              of.pixel_shader ? `; pixel shader of ${of.pixel_shader.slots} slots, ${of.pixel_shader.temporaries} registers, ${of.pixel_shader.profile}` : ""),
                 h("div", { class: "cols" },
                   h("div", {}, funnel(stop), h("h3", {}, "Units"),
                     table(["unit", "", "because"], of.units.map((row) => [row.unit, row.runs ? h("b", {}, "\u25cf runs") : h("span", { class: "note whole" }, "\u25cb left out"), row.why]))),
                   h("div", {}, states(pass, of), textures(of), uniforms(of), times(frame))));
    },
};
