// The history of the chosen pixel: every fragment in order, with its verdict, and what is not there.

import { h, num, swatch, value, vec } from "page/element.js";
import { by_fragment } from "page/frame.js";
import { choose, on_change, state } from "page/state.js";

// A sign and a colour for each verdict; the words say it too.
const signs = [["\u25cf", "good", "written, and what you see"], ["\u25d0", "warn", ""], ["\u2716", "bad", ""],
               ["\u2716", "bad", ""], ["\u2716", "bad", ""], ["\u2716", "bad", ""], ["\u2716", "bad", ""],
               ["\u2716", "bad", ""], ["\u25b3", "bad", ""], ["\u25b3", "bad", ""]];

/** What is known of the chosen pixel: { list (of all fragments), details (of recorded ones, or null),
 * one (the chosen fragment's detail), primitive (of the chosen one) }. */
export const pixel = { list: [], details: null, one: null, primitive: null };

async function load(frame) {
    const { pass, x, y } = state, of = frame.passes[pass];
    const inside = x < of.width && y < of.height;
    pixel.list = inside ? (await frame.fragments(pass)).at(x, y) : [];
    const events = inside ? await frame.history(pass, x, y) : null;
    pixel.details = events && by_fragment(events);
    const last = pixel.list.findLastIndex((one) => one.verdict === 0);
    const default_one = last >= 0 ? last : pixel.list.length - 1;
    if (state.fragment >= pixel.list.length || state.fragment < 0)
        state.fragment = default_one;
    return default_one;
}

async function choose_detail(frame) {
    const chosen = pixel.list[state.fragment];
    pixel.one = chosen && pixel.details?.find((d) => d.draw === chosen.draw && d.primitive === chosen.primitive &&
                                             (chosen.verdict >= 8) === Boolean(d.missed)) || null;
    pixel.primitive = chosen ? await frame.primitive(state.pass, chosen.draw, chosen.primitive) : null;
}

// "depth test: 0.93 less-equal 0.91" of the test that ended a fragment, where it is recorded.
function reason(detail) {
    const failed = detail?.tests.find((test) => !test.passed);
    if (failed && failed.unit === "depth")
        return h("small", {}, "its depth ", value(failed.incoming, "incoming"), ` is not ${failed.compare} `, value(failed.stored, "stored"));
    if (failed && ["stencil", "alpha test"].includes(failed.unit))
        return h("small", {}, value(failed.incoming, "incoming"), ` is not ${failed.compare} `, value(failed.stored, "stored"));
    if (detail?.missed)
        return h("small", {}, detail.missed.reason === "facing"
            ? `turns ${detail.missed.front ? "clockwise" : "counter-clockwise"}, which this draw culls`
            : `only the ${detail.missed.reason} cut it away here`);
    return null;
}

function fragment_line(frame, fragment, i) {
    const draw = frame.draw_of(state.pass, fragment.draw);
    const detail = pixel.details?.find((d) => d.draw === fragment.draw && d.primitive === fragment.primitive);
    const seen = fragment.verdict === 0 && i === pixel.list.findLastIndex((one) => one.verdict === 0);
    const [sign, tone] = signs[fragment.verdict];
    const output = detail?.outputs[0];
    return h("li", {}, h("button", { type: "button", "aria-pressed": String(i === state.fragment),
                                     onclick: () => choose({ fragment: i, draw: fragment.draw }) },
        h("span", { class: `sign ${tone}`, "aria-hidden": "true" }, sign),
        h("span", {}, h("b", {}, draw ? draw.name || draw.program.replace(/_program$/, "") : `draw ${fragment.draw}`),
          ` triangle ${fragment.primitive}`,
          h("small", {}, `draw ${fragment.draw}: `, h("span", { class: tone },
            fragment.verdict >= 8 ? `not here: ${frame.verdicts[fragment.verdict]}`
            : fragment.verdict > 1 ? `stopped: ${frame.verdicts[fragment.verdict]}`
            : seen ? "written last: what you see" : frame.verdicts[fragment.verdict])),
          reason(detail),
          output && h("small", {}, swatch(output.result), "stored ", vec(output.result, "result")))));
}

/** What the exact picture says of the chosen pixel; "" where it is not known. */
export async function against_truth(frame) {
    const off = await frame.off(), { pass, x, y } = state;
    if (!off || !frame.has_picture(pass))
        return "";
    const by = off[y * frame.width + x];
    return h("p", { class: "callout" }, by ? [h("b", { class: "bad" }, "\u2260 "), "Against the exact picture it is off by ", value(by, "truth.off"), ": ", by > 0 ? frame.truth.over : frame.truth.under]
        : [h("b", { class: "good" }, "\u2714 "), "It is as in the exact picture."]);
}

async function render(frame, section) {
    const { pass, x, y } = state, of = frame.passes[pass];
    const target = of.targets.find((one) => one.slot === "0");
    const clear = target?.clear;
    const recorded = pixel.details !== null, nearest = recorded ? null : frame.nearest(pass, x, y);
    section.replaceChildren(
        h("h2", {}, "This pixel"),
        h("p", {}, h("b", {}, `${x}, ${y}`), ` of pass ${pass}${of.name ? `, ${of.name}` : ""}`),
        clear ? h("p", { class: "note" }, "cleared to ", swatch(clear), clear.map((c, i) => (i ? ", " : "") + num(c))) : "",
        pixel.list.length ? h("ol", { class: "fragments" }, pixel.list.map((one, i) => fragment_line(frame, one, i)))
                          : h("p", {}, "No triangle of this pass covers it, nor would one without culling and near and far plane."),
        !recorded && nearest ? h("div", { class: "callout" },
            "Which triangles cover this pixel, and what became of them, is recorded of every pixel. All values of all units are recorded of some. ",
            h("button", { type: "button", onclick: () => choose({ x: nearest[0], y: nearest[1], fragment: -1 }) },
              `Nearest: ${nearest[0]}, ${nearest[1]} (n)`),
            h("p", { class: "note" }, "To have this one: ", h("code", {}, `--region ${x} ${y} 1 1`))) : "",
        await against_truth(frame));
}

export function make_pixel(frame, section) {
    on_change(async (changed) => {
        const moved = ["x", "y", "pass", "first"].some((key) => changed.has(key));
        if (moved) {
            if (!changed.has("fragment"))
                state.fragment = -1;
            await load(frame);
        }
        if (moved || changed.has("fragment")) {
            await choose_detail(frame);
            await render(frame, section);
        }
    });
}
