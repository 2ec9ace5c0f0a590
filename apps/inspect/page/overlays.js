// What can be laid over a target: from the fragments of every pixel, which are all recorded.

import { h } from "page/element.js";

// Blue to yellow by even steps of lightness, so that it is read without colour too.
const ramp = ["#000000", "#16245c", "#2b4f9e", "#2f7fb5", "#3faaa0", "#7fca74", "#cfe05a", "#fff7a8", "#ffffff"];

function rgb(hex) {
    return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

function key(color, text) {
    return h("span", {}, h("span", { class: "swatch", style: `background: ${color}` }), text);
}

// Paints a number a pixel by the ramp; 0 lets the picture through.
function paint_counts(canvas, counts, words) {
    const context = canvas.getContext("2d"), data = new ImageData(canvas.width, canvas.height);
    const colors = ramp.map(rgb);
    let most = 0;
    for (let i = 0; i < counts.length; i++) {
        const level = Math.min(counts[i], ramp.length - 1);
        most = Math.max(most, counts[i]);
        if (counts[i])
            data.data.set([...colors[level], 225], 4 * i);
    }
    context.putImageData(data, 0, 0);
    return [...ramp.slice(1).map((color, i) => key(color, i + 2 === ramp.length ? `${i + 1} or more` : String(i + 1))),
            h("span", {}, `${words}; at most ${most}`)];
}

const drawn = (one) => one.verdict < 8; // culled and clipped triangles have no fragments

async function each_pixel(frame, state, visit) {
    const pass = frame.passes[state.pass], fragments = await frame.fragments(state.pass);
    for (let y = 0, i = 0; y < pass.height; y++)
        for (let x = 0; x < pass.width; x++, i++)
            visit(fragments.at(x, y).filter((one) => one.draw <= state.draw), i, x, y);
}

function fits(canvas, frame, state) {
    const pass = frame.passes[state.pass];
    return canvas.width === pass.width && canvas.height === pass.height;
}

async function count_fragments(canvas, frame, state, words, of) {
    const counts = new Uint32Array(canvas.width * canvas.height);
    await each_pixel(frame, state, (list, i) => { counts[i] = of(list); });
    return paint_counts(canvas, counts, words);
}

// Where the visible triangle, or draw, of a pixel differs from that of the next.
async function edges(canvas, frame, state, same) {
    const { width, height } = canvas, top = new Array(width * height);
    await each_pixel(frame, state, (list, i) => { top[i] = list.findLast((one) => one.verdict === 0); });
    const data = new ImageData(width, height);
    for (let y = 0, i = 0; y < height; y++)
        for (let x = 0; x < width; x++, i++)
            if ((x + 1 < width && !same(top[i], top[i + 1])) || (y + 1 < height && !same(top[i], top[i + width])))
                data.data.set([255, 255, 255, 230], 4 * i);
            else
                data.data.set([0, 0, 0, 110], 4 * i);
    canvas.getContext("2d").putImageData(data, 0, 0);
    return [key("#fff", "borders of visible triangles, at pixels")];
}

const same_triangle = (a, b) => a === b || (a && b && a.draw === b.draw && a.primitive === b.primitive);

async function sizes(canvas, frame, state) {
    const { width, height } = canvas, area = new Map(), top = new Array(width * height);
    await each_pixel(frame, state, (list, i) => {
        const one = list.findLast((fragment) => fragment.verdict === 0);
        top[i] = one && `${one.draw}/${one.primitive}`;
        if (one)
            area.set(top[i], (area.get(top[i]) ?? 0) + 1);
    });
    const levels = Uint32Array.from(top, (name) => name ? 1 + Math.min(7, Math.floor(Math.log2(area.get(name)) / 2)) : 0);
    paint_counts(canvas, levels, "");
    return ramp.slice(1).map((color, i) => key(color, i === 7 ? `${4 ** i} pixels or more` : `from ${4 ** i}`));
}

async function verdicts(canvas, frame, state) {
    const tests = ["#9aa0a6", "#9aa0a6", "#d55e00", "#cc79a7", "#56b4e9", "#e69f00", "#0072b2", "#f0e442", "#000000", "#ffffff"];
    const data = new ImageData(canvas.width, canvas.height);
    await each_pixel(frame, state, (list, i) => {
        const last = list.findLast((one) => one.verdict > 1);
        if (last)
            data.data.set([...rgb(tests[last.verdict]), 235], 4 * i);
    });
    canvas.getContext("2d").putImageData(data, 0, 0);
    return frame.verdicts.slice(2).map((text, i) => key(tests[i + 2], text));
}

async function quads(canvas, frame, state) {
    const pass = frame.passes[state.pass], fragments = await frame.fragments(state.pass);
    const counts = new Uint32Array(canvas.width * canvas.height);
    for (let y = 0; y < pass.height; y += 2)
        for (let x = 0; x < pass.width; x += 2) {
            const shaded = new Set();
            for (const [px, py] of [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]])
                if (px < pass.width && py < pass.height)
                    for (const one of fragments.at(px, py))
                        if (drawn(one) && one.draw <= state.draw)
                            shaded.add(`${one.draw}/${one.primitive}`);
            for (const [px, py] of [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]])
                if (px < pass.width && py < pass.height)
                    counts[py * pass.width + px] = shaded.size;
        }
    return paint_counts(canvas, counts, "quads of triangles that cover some of the four pixels");
}

async function facing(canvas, frame, state) {
    const data = new ImageData(canvas.width, canvas.height);
    await each_pixel(frame, state, (list, i, x, y) => {
        const top = list.findLast((one) => one.verdict === 0);
        if (top) // backs are hatched, fronts are not
            data.data.set(top.front ? [86, 180, 233, 150] : (x + y) % 6 < 3 ? [213, 94, 0, 230] : [60, 20, 0, 230], 4 * i);
    });
    canvas.getContext("2d").putImageData(data, 0, 0);
    return [key("#56b4e9", "front (clockwise)"), key("repeating-linear-gradient(45deg, #d55e00 0 3px, #3c1400 3px 6px)", "back, hatched")];
}

async function levels(canvas, frame, state) {
    const codes = await frame.lod(state.pass);
    if (!codes)
        return [h("span", {}, "this pass reads no texture")];
    const shown = Uint32Array.from(codes, (code) => code ? code <= 128 ? 1 : Math.min(8, 2 + Math.floor((code - 128) / 16)) : 0);
    paint_counts(canvas, shown, "");
    return [key(ramp[1], "magnified, level 0 or below"), ...ramp.slice(2).map((color, i) => key(color, `${i} to ${i + 1}`))];
}

// Above the exact picture, or below it: two colours and two hatchings, the darker the farther.
async function off_truth(canvas, frame, state) {
    const off = await frame.off();
    if (!off || !frame.has_picture(state.pass))
        return [h("span", {}, frame.truth ? "of the picture's own pass" : "the exact picture is not in this page: --technique NAME --truth has it")];
    const most = off.reduce((a, b) => Math.max(a, Math.abs(b)), 1e-9), data = new ImageData(canvas.width, canvas.height);
    for (let y = 0, i = 0; y < canvas.height; y++)
        for (let x = 0; x < canvas.width; x++, i++)
            if (off[i])
                data.data.set([...(off[i] > 0 ? [213, 94, 0] : (x + y) % 4 < 2 ? [0, 114, 178] : [180, 220, 255]), 90 + 165 * Math.min(1, Math.abs(off[i]) / most)], 4 * i);
    canvas.getContext("2d").putImageData(data, 0, 0);
    return [key("#d55e00", frame.truth.over), key("repeating-linear-gradient(45deg, #0072b2 0 3px, #b4dcff 3px 6px)", `${frame.truth.under}, hatched`), h("span", {}, `${count_of(off)} pixels are off`)];
}

function count_of(off) {
    return off.reduce((sum, one) => sum + (one !== 0), 0);
}

function tiles(canvas) {
    const context = canvas.getContext("2d"), size = 64; // pipeline/fast/fast.h
    context.clearRect(0, 0, canvas.width, canvas.height);
    for (let y = 0; y < canvas.height; y += size)
        for (let x = 0; x < canvas.width; x += size) {
            context.fillStyle = (x + y) / size % 2 ? "rgb(255 255 255 / .16)" : "rgb(0 0 0 / .28)";
            context.fillRect(x, y, size, size);
        }
    return [h("span", {}, `tiles of ${size} by ${size} pixels; which thread draws one is left to chance, and changes no bit`)];
}

const wrapped = (paint) => async (canvas, frame, state, image) =>
    fits(canvas, frame, state) ? paint(canvas, frame, state, image) : [h("span", {}, "not of this size")];

/** By key: title; paint(canvas, frame, state) returns a legend. */
export const overlays = {
    none: { title: "none", paint: (canvas) => { canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height); } },
    wireframe: { title: "wireframe", paint: wrapped((c, f, s) => edges(c, f, s, same_triangle)) },
    depth: { title: "depth complexity", paint: wrapped((c, f, s) => count_fragments(
        c, f, s, "fragments on a pixel", (list) => list.filter(drawn).length)) },
    written: { title: "writes", paint: wrapped((c, f, s) => count_fragments(
        c, f, s, "times written", (list) => list.filter((one) => one.verdict < 2).length)) },
    quads: { title: "quad overdraw", paint: wrapped(quads) },
    facing: { title: "facing", paint: wrapped(facing) },
    lod: { title: "level of detail", paint: wrapped(levels) },
    tiles: { title: "tiles", paint: tiles },
    size: { title: "triangle size", paint: wrapped(sizes) },
    truth: { title: "off the exact picture", paint: wrapped(off_truth) },
    verdicts: { title: "what was rejected", paint: wrapped(verdicts) },
};
