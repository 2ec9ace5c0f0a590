// The keyboard, and the sheet that tells of it.

import { h } from "page/element.js";
import { pixel } from "page/pixel.js";
import { choose, state } from "page/state.js";
import { shown_units, units } from "page/units.js";

const sheet = [
    ["\u2190 \u2192 \u2191 \u2193", "the pixel beside; with Shift ten further"],
    ["n", "the nearest pixel that is recorded whole"],
    ["[ and ]", "the draw before, the draw after"],
    ["< and >", "the fragment of this pixel before, and after"],
    ["1 \u2026 9, 0", "a unit: 1 is the draw, 2 input assembly, ... 0 the pixel shader"],
    ["u and i", "the unit before, the unit after"],
    ["j and k", "the shader's next step, and the one before"],
    ["?", "this sheet"],
];
const signs = [
    ["\u25cf", "written: the last one is what you see"], ["\u25d0", "written, and hidden by a later one"], ["\u2716", "stopped by a test, or killed by its shader"],
    ["\u25b3", "not here: its triangle was culled, or clipped away"], ["\u25c6 \u25cf \u25cb", "of a quad: this pixel, covered, helper"],
];

export function make_keys(frame, help, button) {
    const pair = ([key, text]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, text)];
    help.append(h("div", { class: "cols" }, h("div", {}, h("h2", {}, "Keys"), h("dl", {}, sheet.map(pair))), h("div", {}, h("h2", {}, "Signs"), h("dl", {}, signs.map(pair)))));
    const toggle = () => {
        help.hidden = !help.hidden;
        button.setAttribute("aria-expanded", String(!help.hidden));
    };
    button.addEventListener("click", toggle);

    const size = () => frame.passes[state.pass];
    const move = (dx, dy) => choose({ x: Math.min(size().width - 1, Math.max(0, state.x + dx)), y: Math.min(size().height - 1, Math.max(0, state.y + dy)) });
    const fragment = (by) => {
        const next = Math.min(pixel.list.length - 1, Math.max(0, state.fragment + by));
        return pixel.list.length ? choose({ fragment: next, draw: pixel.list[next].draw, step: 0 }) : null;
    };
    const unit = (by) => {
        const all = shown_units(frame);
        return choose({ unit: all[Math.min(all.length - 1, Math.max(0, all.findIndex((one) => one.id === state.unit) + by))].id });
    };
    const draw = (by) => {
        const all = frame.passes.flatMap((pass) => pass.draws.map((one) => [pass.pass, one.draw]));
        const at = all.findIndex(([p, d]) => p === state.pass && d === state.draw);
        const next = all[Math.min(all.length - 1, Math.max(0, at + by))];
        return next ? choose({ pass: next[0], draw: next[1] }) : null;
    };
    const nearest = () => {
        const place = frame.nearest(state.pass, state.x, state.y);
        return place ? choose({ x: place[0], y: place[1] }) : null;
    };
    const keys = {
        n: nearest, "[": () => draw(-1), "]": () => draw(1), "<": () => fragment(-1), ">": () => fragment(1), ",": () => fragment(-1), ".": () => fragment(1),
        u: () => unit(-1), i: () => unit(1), j: () => choose({ step: state.step + 1 }), k: () => choose({ step: Math.max(0, state.step - 1) }), "?": toggle,
    };
    "1234567890".split("").forEach((key, i) => { keys[key] = () => choose({ unit: units[Math.min(i, units.length - 1)].id }); });

    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("select, input"))
            return;
        const scrolls = event.target.closest("pre, .list, .formula");
        const far = event.shiftKey ? 10 : 1;
        const arrows = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] };
        if (arrows[event.key] && !scrolls && (event.target.closest(".stage") || event.target === document.body))
            move(...arrows[event.key]);
        else if (event.target.closest("#strip") && ["ArrowLeft", "ArrowRight"].includes(event.key))
            Promise.resolve(unit(event.key === "ArrowRight" ? 1 : -1)).then(() => document.getElementById(`tab-${state.unit}`).focus());
        else if (keys[event.key])
            keys[event.key]();
        else
            return;
        event.preventDefault();
    });
}
