// Many fragments: those of a pixel in order of depth, which pass took which, and what was put together so far.

import { h, table, value } from "page/element.js";
import { bar, colour, draws_with, fate_cell, gaps, go_to, is_chosen, numbers, source_of, story } from "page/techniques/story.js";

// Everything that is drawn of the mesh, once, in order of depth: by the recorded turn where the machine sorts.
function in_order(all) {
    const known = new Map();
    for (const { pass, fragments } of all)
        for (const one of fragments.filter((fragment) => fragment.interpolate && fragment.draw_of.primitives > 1)) {
            const key = `${one.draw_of.program.startsWith("convex") ? one.draw : ""}/${one.primitive}`;
            const entry = known.get(key) ?? { pass, one, taken: [] };
            if (one.outputs.length || (!one.pixel?.killed && one.tests.every((test) => test.passed)))
                entry.taken.push({ pass, one });
            known.set(key, entry);
        }
    return [...known.values()].sort((a, b) => (a.one.sort && b.one.sort ? a.one.sort.place - b.one.sort.place : a.one.interpolate.depth - b.one.interpolate.depth) || a.one.primitive - b.one.primitive);
}

function list_of(frame, context, order) {
    return table(["", "triangle", "depth", "taken by pass", ""], order.map(({ pass, one, taken }, i) => ({
        properties: { class: is_chosen(context, pass, one) && "now" },
        cells: [String(i), go_to(frame, pass, one, `${one.draw}/${one.primitive}`), one.sort ? value(one.sort.depth, `${one.path}.sort.depth`) : value(one.interpolate.depth, `${one.path}.interpolate.depth`),
                taken.map((of, k) => [k ? ", " : "", go_to(frame, of.pass, of.one, `${of.pass.pass}, ${of.pass.name}`)]), taken.length ? "" : h("span", { class: "bad" }, "\u2716 by none")] })));
}

// What every pass did here, one row for each fragment that it wrote.
function passes_of(frame, context, all) {
    const rows = [];
    for (const { pass, fragments } of all) {
        const sorted = fragments.some((one) => one.sort) ? fragments.toSorted((a, b) => (a.sort?.place ?? 0) - (b.sort?.place ?? 0)) : fragments;
        for (const one of sorted)
            for (const [t, output] of one.outputs.entries())
                rows.push({ properties: { class: is_chosen(context, pass, one) && "now" }, cells: [
                    `${pass.pass}, ${pass.name}`, go_to(frame, pass, one, `${one.draw}/${one.primitive}`), String(output.target),
                    output.blend.op === "off" ? "replaces" : output.blend.op, colour(output.source, `${one.path}.output.${t}.source`),
                    [numbers(output.result, (c) => `${one.path}.output.${t}.result.${c}`), " ", bar(output.result[3])]] });
    }
    return table(["pass", "draw/triangle", "target", "how", "what comes", "what is there then"], rows);
}

// Fragments that came and were turned away, by pass.
function refused(frame, all) {
    const rows = all.flatMap(({ pass, fragments }) => fragments.filter((one) => !one.outputs.length && (one.pixel?.killed || one.tests.some((test) => !test.passed)))
        .map((one) => [`${pass.pass}, ${pass.name}`, go_to(frame, pass, one, `${one.draw}/${one.primitive}`), one.interpolate ? value(one.interpolate.depth, `${one.path}.interpolate.depth`) : "", fate_cell(one)]));
    return rows.length ? [h("h3", {}, "Turned away"), table(["pass", "draw/triangle", "depth", ""], rows)] : "";
}

export const fragments = {
    id: "fragments", title: "Many fragments", tab: "Fragments", needs: "draw", source: (context) => source_of(context, "fragments", "shaders_c/fragments/fragment_shared.h"), rules: "R30 to R35, R53",
    says: ["Through a transparent pixel one sees every surface behind it, so each must be laid over those behind it: order matters, and triangles do not come in order.",
           "Sorting keeps all fragments of a pixel until the pass ends; peeling draws the mesh again and again, and each pass takes the nearest fragment behind what the last one took.",
           "Other methods keep a few fragments in the texels of several targets, or weigh all of them without an order and are nearly right."],
    formula: "over:  C = source + (1 \u2212 \u03b1\u209b) C     from the back\nunder: C = C + (1 \u2212 \u03b1) source     from the front\npeel:  passes only where depth > depth of the last layer",
    applies: ({ frame }) => draws_with(frame, "fragments"),
    make: async (context) => {
        const { frame } = context, all = await story(frame, "shaders_c/"), own = all.filter(({ fragments: list }) => list.length);
        const order = in_order(own);
        return h("div", {}, gaps(all),
            order.length ? [h("h3", {}, `${order.length} fragments, from the ${own.some(({ pass }) => pass.order === "depth") ? "first in their order to the last" : "nearest to the farthest"}`), list_of(frame, context, order)] : h("p", {}, "The mesh does not cover this pixel."),
            own.length ? [h("h3", {}, "Pass by pass"), passes_of(frame, context, own), refused(frame, own)] : "");
    },
};
