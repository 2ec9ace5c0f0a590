// Volumes: what the ray of a pixel met, sample by sample, slice by slice or splat by splat.

import { h, svg, swatch, table, value } from "page/element.js";
import { listing_of, watched } from "page/steps.js";
import { bar, colour, draws_with, fate_cell, gaps, go_to, is_chosen, numbers, source_of, story } from "page/techniques/story.js";

const most = 400; // rows of a table

// Watched values of a loop, one object a turn: a new one begins with each "step".
function turns_of(listing, one) {
    const turns = [];
    for (const watch of watched(listing, one.steps)) {
        if (watch.name === "step")
            turns.push({});
        if (turns.length)
            turns.at(-1)[watch.name] = { of: watch.of, path: (c) => `${one.path}.${watch.path(c)}` };
    }
    return turns.filter((turn) => turn.light?.of[0] > 0);
}

function curve(turns) {
    const w = 480, hh = 150, X = (i) => 34 + (w - 44) * (turns.length > 1 ? i / turns.length : 0), Y = (v) => 8 + (hh - 34) * (1 - v);
    return h("figure", {}, svg("svg", { viewBox: `0 0 ${w} ${hh}`, width: w, role: "img", "aria-label": "Light that is left, sample by sample" },
        [0, .5, 1].map((v) => [svg("path", { d: `M34 ${Y(v)}H${w - 10}`, stroke: "var(--line)" }), svg("text", { x: 4, y: Y(v) + 4 }, String(v))]),
        turns.map((turn, i) => svg("rect", { x: X(i) + .5, width: Math.max(.5, X(1) - X(0) - 1), y: Y(turn.met.of[3]), height: Y(0) - Y(turn.met.of[3]), fill: "var(--accent)", opacity: .55 })),
        svg("path", { d: "M" + [1, ...turns.map((turn) => turn.seen.of[0])].map((v, i) => `${X(i)} ${Y(v)}`).join("L"), fill: "none", stroke: "var(--mark)", "stroke-width": 2 }),
        svg("text", { x: w / 2 - 30, y: hh - 6 }, "along the ray \u2192")),
        h("figcaption", {}, "Line: how much light of what lies behind still comes through. Bars: the opacity of each sample."));
}

function of_ray(listing, one) {
    const turns = turns_of(listing, one), path = (turn, name) => numbers(turn[name].of, turn[name].path);
    if (!turns.length)
        return h("p", {}, "The ray of this pixel meets nothing of the volume, or all that it meets is empty.");
    return [h("p", {}, `${turns.length} samples count; places where whole bricks are empty were stepped over.`), curve(turns),
            table(["step", "met: colour \u00d7 opacity, opacity", "light left before", "colour so far", "light left after"], turns.slice(0, most).map((turn) => [
                path(turn, "step"), [swatch(turn.met.of), path(turn, "met")], path(turn, "light"), path(turn, "color"), [path(turn, "seen"), " ", bar(turn.seen.of[0])]])),
            turns.length > most ? h("p", { class: "note" }, `and ${turns.length - most} more: the pixel shader's steps have them.`) : ""];
}

// Fragments that are put over or under each other: slices, splats, sheets.
async function rows_of(frame, context, { pass, fragments }) {
    return Promise.all(fragments.map(async (one) => {
        const listing = await listing_of(pass, one.steps), named = {};
        for (const watch of watched(listing, one.steps))
            named[watch.name] = value(watch.of[0], `${one.path}.${watch.path(0)}`);
        const output = one.outputs[0];
        return { properties: { class: is_chosen(context, pass, one) && "now" }, cells: [
            `${pass.pass}, ${pass.name}`, go_to(frame, pass, one, `${one.draw}/${one.primitive}`), named.value ?? named.weight ?? "",
            output ? colour(output.source, `${one.path}.output.0.source`) : fate_cell(one),
            output ? [numbers(output.blended, (c) => `${one.path}.output.0.blended.${c}`), " ", bar(output.blended[3])] : ""] };
    }));
}

export const volume = {
    id: "volume", title: "Volume", needs: "draw", source: (context) => source_of(context, "volume", "shaders_c/volume/raycast.c"), rules: "R30 to R33, R40 to R45",
    says: ["A volume has values at the corners of a grid; a table, the transfer function, says of each value which colour it sends out, and how much of the light from behind it takes.",
           "A pixel shows what its line of sight meets: each sample lies before those that follow, and only what is left of the light comes through.",
           "A ray takes the samples one by one in its shader; slices and splats are drawn one by one, and blending does the same sum."],
    formula: "colour = colour + light \u00b7 opacity\u1d62 colour\u1d62\nlight  = light \u00b7 (1 \u2212 opacity\u1d62)\nslab   = 1 \u2212 2^(density \u00b7 length)",
    applies: ({ frame }) => draws_with(frame, "volume"),
    make: async (context) => {
        const { frame } = context, all = await story(frame, "shaders_c/volume/");
        const rays = all.flatMap(({ pass, fragments }) => fragments.map((one) => [pass, one])).filter(([, one]) => one.draw_of.program.startsWith("raycast"));
        const blended = all.filter(({ fragments }) => fragments.some((one) => !one.draw_of.program.startsWith("raycast")));
        const parts = [];
        for (const [pass, one] of rays) {
            const listing = await listing_of(pass, one.steps);
            parts.push(one.steps ? of_ray(listing, one) : h("p", { class: "note" }, "The steps of this ray are not in the page."));
        }
        const rows = (await Promise.all(blended.map((part) => rows_of(frame, context, part)))).flat();
        if (rows.length)
            parts.push(h("p", {}, `${rows.length} fragments, in the order in which they were drawn:`),
                       table(["pass", "draw/primitive", blended.some(({ pass }) => pass.name === "sheet") ? "weight" : "value, weight", "what it adds", "so far in its target"], rows.slice(0, most)));
        return h("div", {}, gaps(all), parts.length ? parts : h("p", {}, "Nothing of a volume is at this pixel."));
    },
};
