// The page of a frame: loads it, makes its parts, and starts with what the address asks for.

import { h } from "page/element.js";
import { make_compare } from "page/compare.js";
import { make_events } from "page/events.js";
import { Frame } from "page/frame.js";
import { make_keys } from "page/keys.js";
import { begin_lesson, load_lesson, make_lesson } from "page/lesson.js";
import { make_pixel, pixel } from "page/pixel.js";
import { choose, from_address, idle, state } from "page/state.js";
import { make_units, shown_units } from "page/units.js";
import { Viewer } from "page/viewer.js";

function left_out(frame) {
    const last = frame.passes.at(-1), lines = [
        `Every fragment of every pixel is in this page. All values of all units are in it of ${last.histories.pixels.length} pixels of the last pass: on a grid of ${frame.grid} pixels, and some for every fate that a draw's fragments had.`,
        "For others, make the page again with --region X Y WIDTH HEIGHT, --draw N or --pixels N."];
    if (frame.share < 1)
        lines.push(`The page would have grown beyond ten megabytes: of the pixels that were asked for, or that are usual, about ${Math.max(1, Math.round(100 * frame.share))} in a hundred are recorded whole.`);
    for (const pass of frame.passes)
        if (pass.histories.left_out)
            lines.push(`Pass ${pass.pass}: ${pass.histories.left_out} more events, or shaders' steps, of its recorded pixels had no room. They are the last ones; --region and a small --pixels have them.`);
    for (const pass of frame.passes)
        if (pass.fragments_left_out)
            lines.push(`Pass ${pass.pass}: ${pass.fragments_left_out} fragments have no place in the page.`);
    return lines.map((line) => h("p", {}, line));
}

// The picture's pass, after its last draw, at the recorded pixel nearest to its middle.
function beginning(frame) {
    const pass = frame.passes.findLast((one) => one.targets.some((target) => target.surface === frame.picture)) ?? frame.passes.at(-1);
    const [x, y] = frame.nearest(pass.pass, pass.width >> 1, pass.height >> 1) ?? [0, 0];
    return { pass: pass.pass, draw: Math.max(0, pass.draws.length - 1), surface: frame.picture, x, y, fragment: -1 };
}

/** number: the frame's blob; other: that of a frame to compare with, lesson: of a question, or -1. */
export async function start(number, other, lesson_number) {
    const frame = await Frame.load(number), lesson = await load_lesson(lesson_number);
    const timings = document.getElementById("timings");
    frame.timings = timings ? JSON.parse(timings.textContent) : null;
    const part = (id) => document.getElementById(id);
    part("title").textContent = lesson?.title ?? frame.title;
    part("about").textContent = lesson?.learn ?? frame.about ?? `${frame.width} \u00d7 ${frame.height}, ${frame.passes.length} pass${frame.passes.length > 1 ? "es" : ""}; both executors drew the same bits`;
    part("left-out").append(...left_out(frame));
    make_events(frame, part("events"));
    make_pixel(frame, part("pixel"));
    const viewer = new Viewer(frame, part("viewer"));
    if (other >= 0)
        await make_compare(frame, await Frame.load(other), viewer);
    make_units(frame, part("strip"), part("panel"));
    make_keys(frame, part("help"), part("help-button"));
    await choose({ ...beginning(frame), ...begin_lesson(frame, lesson), ...from_address(), first: true });
    await make_lesson(lesson, part("lesson"));
    window.inspector = { frame, state, choose, idle, pixel, milliseconds: performance.now(), get units() { return shown_units(frame).map((unit) => unit.id); } };
    document.documentElement.dataset.ready = "true";
}
