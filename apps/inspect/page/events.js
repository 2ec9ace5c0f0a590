// The frame as a list: passes, their draws, and how many pixels each wrote.

import { count, h } from "page/element.js";
import { choose, on_change, state } from "page/state.js";

function draw_line(pass, draw, stop) {
    const chosen = () => choose({ pass: pass.pass, draw: draw.draw });
    return h("li", {}, h("button", { type: "button", "data-draw": `${pass.pass}/${draw.draw}`, onclick: chosen },
                         h("span", { class: "number" }, draw.draw),
                         h("span", {}, draw.name || draw.program.replace(/_program$/, "")),
                         h("span", { class: "amount", title: "pixels written" },
                           stop && stop.count === 1 ? count(stop.counters.written) : "")));
}

export function make_events(frame, nav) {
    nav.append(h("h2", {}, "The frame"));
    for (const pass of frame.passes) {
        nav.append(h("div", { class: "pass" }, `Pass ${pass.pass}${pass.name ? `, ${pass.name}` : ""}`,
                     h("span", {}, `${pass.width} \u00d7 ${pass.height}`)),
                   h("ol", {}, pass.draws.map((draw) => draw_line(pass, draw, pass.stops.find(
                       (stop) => draw.draw >= stop.first && draw.draw < stop.first + stop.count)))));
        if (pass.draw_count > pass.draws.length)
            nav.append(h("p", { class: "note" }, `and ${count(pass.draw_count - pass.draws.length)} more draws`));
    }
    const show = () => {
        for (const button of nav.querySelectorAll("button")) {
            const is = button.dataset.draw === `${state.pass}/${state.draw}`;
            button.setAttribute("aria-current", String(is));
            if (is && !nav.matches(":hover"))
                nav.scrollTop = button.offsetTop - nav.clientHeight / 2;
        }
    };
    on_change((changed) => (changed.has("pass") || changed.has("draw")) && show());
    show();
}
