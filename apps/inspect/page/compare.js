// Two frames of one page: their pictures beside each other, and where a pixel parts ways.

import { count, h, num } from "page/element.js";
import { on_change, state } from "page/state.js";
import { paint } from "page/picture.js";

// The first place at which two values differ: ["path.to.it", one, other], or null.
function first_difference(one, other, path) {
    if (typeof one !== "object" || one === null || typeof other !== "object" || other === null)
        return Object.is(one, other) ? null : [path, one, other];
    for (const key of new Set([...Object.keys(one), ...Object.keys(other)])) {
        const found = first_difference(one[key], other[key], path ? `${path}.${key}` : key);
        if (found)
            return found;
    }
    return null;
}

// What a parting says in words.
function in_words(frame, event, found) {
    if (!event)
        return "one of them goes on where the other ends";
    const [path, one, other] = found, draw = frame.draw_of(state.pass, event.draw);
    return [`${event.kind} of draw ${event.draw}${draw?.name ? `, ${draw.name}` : ""}, triangle ${event.primitive}: `,
            h("code", {}, path), " is ", h("span", { class: "v" }, num(one ?? "nothing")), " here and ",
            h("span", { class: "v" }, num(other ?? "nothing")), " there"];
}

async function parting(frame, other) {
    const of = other.passes[state.pass], { pass, x, y } = state;
    if (!of || x >= of.width || y >= of.height)
        return "the other frame has no such pixel";
    const mine = await frame.history(pass, x, y), theirs = await other.history(pass, x, y);
    if (!mine || !theirs) {
        const one = (await frame.fragments(pass)).at(x, y), two = (await other.fragments(pass)).at(x, y);
        const at = one.findIndex((fragment, i) => JSON.stringify(fragment) !== JSON.stringify(two[i]));
        return at < 0 && one.length === two.length ? "the same triangles with the same fates; its values are not recorded of both"
            : `fragment ${at < 0 ? one.length : at} is another, or fares otherwise; its values are not recorded of both`;
    }
    for (let i = 0; i < Math.max(mine.length, theirs.length); i++) {
        const found = mine[i] && theirs[i] ? first_difference(mine[i], theirs[i], "") : [];
        if (found)
            return in_words(frame, mine[i] && theirs[i] ? mine[i] : null, found);
    }
    return "nowhere: both have the same history";
}

/** Adds the other frame to the viewer, and says at the pixel where both part. */
export async function make_compare(frame, other, viewer) {
    const image = await other.targets.after(other.picture, other.all_stops.length - 1);
    const canvas = h("canvas", { class: "over", "aria-label": other.title });
    paint(canvas, image, "");
    const slide = h("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": `How much of ${frame.title} is seen` });
    const cut = () => { canvas.style.clipPath = `inset(0 0 0 ${slide.value}%)`; };
    slide.addEventListener("input", cut);
    cut();
    const says = h("p", { class: "callout", "aria-live": "polite" });
    viewer.stage.insertBefore(canvas, viewer.over);
    viewer.also.push(canvas);
    viewer.stage.before(h("div", { class: "bar" }, h("label", {}, `left: ${frame.title}`, slide, `right: ${other.title}`),
                          h("span", { class: "note" }, other.differing === null ? "of another size" : `${count(other.differing)} pixels differ`)));
    viewer.legend.before(says);
    on_change(async (changed) => {
        canvas.hidden = state.surface !== frame.picture;
        if (["x", "y", "pass", "first"].some((key) => changed.has(key)))
            says.replaceChildren(`Pixel ${state.x}, ${state.y} parts ways: `, ...[await parting(frame, other)].flat());
    });
}
