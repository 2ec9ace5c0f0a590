// Points: the splats of a pixel, their Gaussians, what was added up, and what was made of the sums.

import { h, num, svg, table, value } from "page/element.js";
import { state } from "page/state.js";
import { listing_of, watched } from "page/steps.js";
import { bar, colour, draws_with, fate, fate_cell, gaps, go_to, is_chosen, numbers, source_of, story, uniform, varying } from "page/techniques/story.js";

const HALF_LOG2_E = 0.72134752; // shaders_c/points/splat_shared.h: the exponent at one standard deviation

// A line of equal weight: x^2 a + x y b + y^2 c is the level.
function ellipse([a, b, c], [x, y], level) {
    const corners = [];
    for (let k = 0; k < 48; k++) {
        const u = Math.cos(k * Math.PI / 24), v = Math.sin(k * Math.PI / 24), r = Math.sqrt(level / (a * u * u + b * u * v + c * v * v));
        corners.push(`${(x + .5 + r * u).toFixed(3)} ${(y + .5 + r * v).toFixed(3)}`);
    }
    return corners.every((corner) => !corner.includes("NaN")) ? `M${corners.join("L")}Z` : "";
}

function picture(splats, chosen) {
    const reach = 5, { x, y } = state, cut = uniform(chosen.one.draw_of, "cut")?.[0] ?? 2;
    const lines = [];
    for (let i = -reach; i <= reach + 1; i++)
        lines.push(`M${x + i} ${y - reach}v${2 * reach + 1}M${x - reach} ${y + i}h${2 * reach + 1}`);
    const shape = (splat, level, properties) => svg("path", { d: ellipse(splat.conic.of, splat.place.of, level), fill: "none", ...properties });
    return h("figure", {}, svg("svg", { viewBox: `${x - reach} ${y - reach} ${2 * reach + 1} ${2 * reach + 1}`, width: 400, role: "img", "aria-label": "The splats about this pixel as ellipses" },
        svg("path", { d: lines.join(""), stroke: "var(--line)", "stroke-width": .03 }),
        splats.filter((splat) => splat !== chosen).map((splat) => shape(splat, HALF_LOG2_E, fate(splat.one)[0] === "\u25cf" ? { stroke: "var(--accent)", "stroke-width": .05 } : { stroke: "var(--soft)", "stroke-width": .04, "stroke-dasharray": ".18 .12" })),
        shape(chosen, HALF_LOG2_E, { stroke: "var(--mark)", "stroke-width": .12, style: "fill: var(--mark); fill-opacity: .14" }),
        shape(chosen, HALF_LOG2_E * cut * cut, { stroke: "var(--mark)", "stroke-width": .07, "stroke-dasharray": ".3 .15" }),
        svg("circle", { cx: chosen.place.of[0] + .5, cy: chosen.place.of[1] + .5, r: .12, fill: "var(--mark)" }),
        svg("rect", { x, y, width: 1, height: 1, fill: "none", stroke: "var(--ink)", "stroke-width": .1 })),
        h("figcaption", {}, `Ellipses at one standard deviation of each Gaussian: whole lines are added, dashed thin ones lie behind the surface. The thick one is surfel ${chosen.one.primitive}; its dashed outline is where it is cut off, ${num(cut)} deviations out. The frame is this pixel.`));
}

// The splats of a pass that adds them up.
async function splats_of({ pass, fragments }) {
    return Promise.all(fragments.map(async (one) => {
        const listing = await listing_of(pass, one.steps), named = {};
        for (const watch of watched(listing, one.steps))
            named[watch.name] = { of: watch.of, path: (c) => `${one.path}.${watch.path(c)}` };
        return { one, pass, conic: varying(one, "conic"), place: varying(one, "place"), ...named };
    }));
}

function one_value(named) {
    return named ? value(named.of[0], named.path(0)) : "";
}

function is_added(splat) {
    return splat.one.outputs.length > 0;
}

// Those that were not added, and why.
function others(splats, context) {
    const words = { "depth test": "behind the surface", discarded: "beyond its cut-off" };
    return splats.length ? [h("h3", {}, `${splats.length} more whose square covers the pixel, and that add nothing`), table(["draw/surfel", "exponent", "weight", ""], splats.map((splat) => ({
        properties: { class: is_chosen(context, splat.pass, splat.one) && "now" },
        cells: [go_to(context.frame, splat.pass, splat.one, `${splat.one.draw}/${splat.one.primitive}`), one_value(splat.exponent), one_value(splat.weight),
                h("span", { class: "bad" }, `\u2716 ${words[fate(splat.one)[2]] ?? fate(splat.one)[2]}`)] })))] : "";
}

function rows_of(splats, context) {
    return splats.map((splat) => {
        const { one } = splat, output = one.outputs[0];
        return { properties: { class: is_chosen(context, splat.pass, one) && "now" }, cells: [
            go_to(context.frame, splat.pass, one, `${one.draw}/${one.primitive}`), one_value(splat.exponent), [one_value(splat.weight), " ", splat.weight ? bar(splat.weight.of[0]) : ""],
            output ? numbers(output.source, (c) => `${one.path}.output.0.source.${c}`) : "", output ? numbers(output.blended, (c) => `${one.path}.output.0.blended.${c}`) : ""] };
    });
}

// How the chosen surfel's Gaussian came about, from its vertex shader.
async function filter_of(frame, { one, pass, conic, place }) {
    const primitive = await frame.primitive(pass.pass, one.draw, one.primitive), vertex = primitive?.vertices[0];
    const listing = vertex && await listing_of(pass, vertex.steps), named = {};
    for (const watch of watched(listing, vertex?.steps))
        named[watch.name] = numbers(watch.of, (c) => `${one.path}.vertices.0.${watch.path(c)}`);
    const rows = [
        ["radius, pixels", named.radius, "of the surfel's disc, were it seen face on"],
        ["facing", named.facing, "cosine of normal and line of sight: the disc is an ellipse, so much thinner"],
        ["V: xx, xy, yy", named.V, `square pixels: the surfel's own Gaussian as it is seen, and the pixel's filter, h = ${num(uniform(one.draw_of, "low_pass")?.[0] ?? "?")}, added to xx and yy`],
        ["conic", numbers(conic.of, conic.path), "V\u207b\u00b9 for powers of 2: weight = 2^\u2212(a x\u00b2 + b x y + c y\u00b2)"],
        ["centre", numbers(place.of, place.path), "pixels, from the middle of pixel 0, 0"],
        ["height", named.height, "the weight in the centre: the area that the surfel stands for, as it is seen"]];
    return [h("h3", {}, `Surfel ${one.primitive} of draw ${one.draw}: its filter`), table(null, rows.filter((row) => row[1]).map(([name, here, words]) => [name, [here, h("div", { class: "note" }, words)]]))];
}

async function normalized({ pass, fragments }) {
    const one = fragments.at(-1), listing = await listing_of(pass, one.steps);
    const rows = watched(listing, one.steps).map((watch) => [{ sums: "sum of colour \u00d7 weight, and of weights", coverage: "coverage" }[watch.name] ?? watch.name,
        numbers(watch.of, (c) => `${one.path}.${watch.path(c)}`)]);
    if (one.outputs[0])
        rows.push(["colour, stored", colour(one.outputs[0].result, `${one.path}.output.0.result`)]);
    return [h("h3", {}, "What is made of the sums"), h("p", {}, "The sum of colours is divided by the sum of weights, so that it does not matter how many splats there are; coverage fades the surface out where the weights end."), table(null, rows)];
}

export const points = {
    id: "points", title: "Splats", needs: "draw", source: (context) => source_of(context, "points", "shaders_c/points/splat.c"), rules: "R12, R18, R30 to R33",
    says: ["A surfel is a point with a normal and a radius: a small disc, and a Gaussian on it that says how much each place counts.",
           "On the screen the Gaussian is an ellipse; the pixel's own filter is added to it, so that no splat falls between pixels: that is EWA.",
           "First the surface's depth is drawn, a little behind it; then all splats before that depth are added, weight by weight, and the sum is divided by the weights."],
    formula: "V      = J \u03a3 J\u1d40 + h I\nweight = height \u00b7 exp(\u2212\u00bd d\u1d40 V\u207b\u00b9 d), cut off at d = cut \u03c3\ncolour = \u03a3 weight\u1d62 colour\u1d62 / \u03a3 weight\u1d62",
    applies: ({ frame }) => draws_with(frame, "points"),
    make: async (context) => {
        const { frame } = context, all = await story(frame, "shaders_c/points/");
        const adds = all.filter(({ fragments }) => fragments.some((one) => varying(one, "conic") && one.steps && one.draw_of.state["blend 0"]?.startsWith("add")));
        const splats = (await Promise.all(adds.map(splats_of))).flat().filter((splat) => splat.conic && splat.place);
        const chosen = splats.find((splat) => is_chosen(context, splat.pass, splat.one)) ?? splats.toSorted((a, b) => is_added(b) - is_added(a) || (b.weight?.of[0] ?? 0) - (a.weight?.of[0] ?? 0))[0];
        const last = all.findLast(({ pass, fragments }) => fragments.length && /normalize|shade|over/.test(pass.draws[0]?.program));
        const hides = all.flatMap(({ fragments }) => fragments).filter((one) => one.draw_of.program.includes("visibility") && fate(one)[0] === "\u25cf").at(-1);
        const plain = all.flatMap(({ pass, fragments }) => fragments.filter((one) => !splats.some((splat) => splat.one === one)).map((one) => [pass, one]));
        return h("div", {}, gaps(all),
            hides ? h("p", {}, "The surface's depth here: ", value(hides.pixel?.depth ?? hides.interpolate.depth, `${hides.path}.${hides.pixel ? "pixel" : "interpolate"}.depth`), ", of surfel ", go_to(frame, all.find(({ fragments }) => fragments.includes(hides)).pass, hides, `${hides.draw}/${hides.primitive}`), ". Splats behind it are not added.") : "",
            chosen ? h("div", { class: "cols" }, h("div", {}, await filter_of(frame, chosen)), picture(splats, chosen)) : "",
            splats.length ? [h("h3", {}, `${splats.filter(is_added).length} splats are added up, in the order in which they were drawn`), table(["draw/surfel", "exponent", "weight", "added: colour \u00d7 weight, weight", "sum so far"], rows_of(splats.filter(is_added), context)),
                             last ? await normalized(last) : "", others(splats.filter((splat) => !is_added(splat)), context)]
                : plain.length ? [h("h3", {}, "Points at this pixel"), table(["pass", "draw/point", "depth", "colour", ""], plain.map(([pass, one]) => [pass.name || String(pass.pass), go_to(frame, pass, one, `${one.draw}/${one.primitive}`),
                    one.interpolate ? value(one.interpolate.depth, `${one.path}.interpolate.depth`) : "", one.outputs[0] ? colour(one.outputs[0].result, `${one.path}.output.0.result`) : "", fate_cell(one)]))]
                : h("p", {}, "No splat covers this pixel."));
    },
};
