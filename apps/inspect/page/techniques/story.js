// What the panels of techniques share: one pixel through all passes of the picture's size.

import { h, num, swatch, value, vec } from "page/element.js";
import { by_fragment } from "page/frame.js";
import { choose, state } from "page/state.js";

/** Whether a frame draws with programs of a folder of shaders. */
export function draws_with(frame, folder) {
    return Object.values(frame.programs).some((path) => path.startsWith(`shaders_c/${folder}/`));
}

/** The source of the chosen fragment's program, else a file of the technique's. */
export function source_of({ frame, draw }, folder, usual) {
    const path = draw && frame.programs[draw.program];
    return path?.startsWith(`shaders_c/${folder}/`) ? path : usual;
}

/** [{ pass, recorded, fragments }] of the chosen pixel, in the frame's order, with the fragments of one folder's programs; each
 * has also draw_of, its draw, and path, where it stands in the record. */
export async function story(frame, folder) {
    const { width, height } = frame.passes[state.pass];
    const all = [];
    for (const pass of frame.passes) {
        if (pass.width !== width || pass.height !== height)
            continue;
        const events = await frame.history(pass.pass, state.x, state.y);
        const own = events ? by_fragment(events).map((one) => ({ ...one, draw_of: pass.draws[one.draw], path: `@${pass.pass}/${one.draw}/${one.primitive}` })) : [];
        all.push({ pass, recorded: events !== null, fragments: own.filter((one) => one.raster && frame.programs[one.draw_of?.program]?.startsWith(folder)) });
    }
    return all;
}

/** Says which passes have more to tell than the page has; "" where all is here. */
export function gaps(all) {
    const missing = all.filter((one) => !one.recorded);
    return missing.length ? h("p", { class: "callout" }, `${missing.length} of ${all.length} passes are not recorded at this pixel: press n for the nearest that is, or make the page with `,
                              h("code", {}, `--region ${state.x} ${state.y} 1 1`), ".") : "";
}

/** A varying by its name: { of, path(c) } or null. */
export function varying(one, name) {
    let at = 0;
    for (const decl of one.draw_of.varyings) {
        if (decl.name === name && one.interpolate) {
            const from = at;
            return { of: one.interpolate.varyings.slice(from, from + decl.components), path: (c) => `${one.path}.interpolate.varyings.${from + c}` };
        }
        at += decl.components;
    }
    return null;
}

/** The text of a named number of a draw's uniforms: [number, ...], or null. */
export function uniform(draw, name) {
    const found = draw?.uniforms?.find((one) => one.name === name || one.name.endsWith(`.${name}`));
    return found ? found.value.flat() : null;
}

/** What became of a fragment: [sign, class, words]. */
export function fate(one) {
    const failed = one.tests.find((test) => !test.passed);
    if (one.pixel?.killed)
        return ["\u2716", "bad", "discarded"];
    if (failed)
        return ["\u2716", "bad", `${failed.unit} test`];
    return ["\u25cf", "good", "written"];
}

/** Its fate as a cell. */
export function fate_cell(one) {
    const [sign, tone, words] = fate(one);
    return h("span", { class: tone }, `${sign} ${words}`);
}

/** A button that goes to a fragment of a pass. */
export function go_to(frame, pass, one, text) {
    const go = async () => {
        const list = (await frame.fragments(pass.pass)).at(state.x, state.y);
        const fragment = list.findIndex((f) => f.draw === one.draw && f.primitive === one.primitive && f.verdict < 8);
        choose({ pass: pass.pass, draw: one.draw, fragment });
    };
    return h("button", { type: "button", class: "link", onclick: go, title: "look at this one in all units" }, text);
}

/** Whether it is the chosen fragment. */
export function is_chosen(context, pass, one) {
    return context.pass === pass && context.fragment?.draw === one.draw && context.fragment?.primitive === one.primitive;
}

/** Colour and numbers of a recorded vector. */
export function colour(of, path) {
    return [swatch(of), vec(of, path)];
}

/** A recorded vector, cut to what is read easily; its whole digits are in each number's title. */
export function numbers(of, path) {
    return h("span", { class: "vec" }, of.map((one, c) => [c ? "  " : "", value(one, path(c))]));
}

/** A share of one as a bar with its number in words. */
export function bar(share) {
    const width = Math.min(1, Math.max(0, Number(share) || 0));
    return h("span", { class: "share", "aria-hidden": "true", title: num(share) }, h("span", { style: `width: ${(100 * width).toFixed(1)}%` }));
}
