// The chosen target as it is after the chosen draw: to be looked at, and clicked.

import { h, num, svg, swatch } from "page/element.js";
import { channel_names } from "page/formats.js";
import { overlays } from "page/overlays.js";
import { paint, ways } from "page/picture.js";
import { choose, on_change, state } from "page/state.js";

function histogram(range) {
    const most = Math.max(...range.bins, 1);
    return svg("svg", { class: "histogram", viewBox: "0 0 256 44", preserveAspectRatio: "none", role: "img",
                        "aria-label": `Histogram from ${num(range.low)} to ${num(range.high)}` },
               [...range.bins].map((bin, i) => svg("rect", {
                   x: 4 * i, width: 3.4, y: 44 - 43 * Math.sqrt(bin / most), height: 43 * Math.sqrt(bin / most),
                   fill: "currentColor", opacity: .55 })));
}

export class Viewer {
    constructor(frame, section) {
        this.frame = frame;
        this.also = []; // further layers of the same size
        this.canvas = h("canvas", { role: "img" });
        this.over = h("canvas", { class: "over" });
        this.cross = svg("svg", { class: "over", "aria-hidden": "true" });
        this.stage = h("div", { class: "stage", tabindex: 0, role: "application",
                                "aria-label": "The target's pixels: arrow keys move, Shift by ten" },
                       this.canvas, this.over, this.cross);
        this.stage.addEventListener("click", (event) => choose(this.pixel_of(event)));
        this.stage.addEventListener("mousemove", (event) => this.hover(event));
        this.stage.addEventListener("mouseleave", () => this.read(state.x, state.y));
        this.surfaces = h("select", { "aria-label": "Target", onchange: (e) => choose({ surface: Number(e.target.value),
                                                                                       channel: "" }) });
        this.ways = h("select", { "aria-label": "Channel", onchange: (e) => choose({ channel: e.target.value }) });
        this.zoom = h("select", { "aria-label": "Size", onchange: () => this.resize() },
                      [["", "fit"], ["1", "1\u00d7"], ["2", "2\u00d7"], ["4", "4\u00d7"], ["8", "8\u00d7"], ["16", "16\u00d7"]]
                          .map(([value, text]) => h("option", { value }, text)));
        this.overlay = h("select", { "aria-label": "Overlay", onchange: (e) => choose({ overlay: e.target.value }) },
                         Object.entries(overlays).map(([key, one]) => h("option", { value: key }, one.title)));
        this.recorded = h("input", { type: "checkbox", onchange: () => this.mark() });
        this.values = h("div", { class: "readout", "aria-live": "polite" });
        this.below = h("div", {});
        this.legend = h("div", { class: "legend" });
        section.append(h("div", { class: "bar" }, h("label", {}, "Target", this.surfaces), h("label", {}, "as", this.ways),
                         h("label", {}, "size", this.zoom), h("label", {}, "overlay", this.overlay),
                         h("label", {}, this.recorded, "pixels recorded whole")),
                       this.stage, this.legend, this.values, this.below);
        on_change((changed) => this.change(changed));
    }

    pixel_of(event) {
        const box = this.canvas.getBoundingClientRect();
        const at = (place, low, size, most) => Math.min(most - 1, Math.max(0, Math.floor((place - low) / size * most)));
        return { x: at(event.clientX, box.left, box.width, this.canvas.width),
                 y: at(event.clientY, box.top, box.height, this.canvas.height) };
    }

    hover(event) {
        const { x, y } = this.pixel_of(event);
        this.read(x, y);
    }

    // The values under the pointer, or of the chosen pixel.
    read(x, y) {
        if (!this.image || x >= this.image.surface.width || y >= this.image.surface.height)
            return;
        const values = this.image.at(x, y), { channels, depth } = this.image.format;
        this.values.replaceChildren(
            h("span", {}, "pixel ", h("b", { class: "v" }, `${x}, ${y}`)),
            h("span", {}, !depth && swatch(values.length < 3 ? [values[0], values[1] ?? values[0], values[0]] : values),
              [...channels].map((c, i) => [i ? "  " : "", channel_names[c], " ",
                                           h("span", { class: "v", "data-stored": values[i] }, num(values[i]))])));
    }

    async change(changed) {
        const has = (...keys) => keys.some((key) => changed.has(key));
        if (has("pass", "draw", "surface", "channel", "first"))
            await this.show();
        if (has("pass", "draw", "overlay", "surface", "first", "fragment", "x", "y"))
            await this.lay_over(has("overlay", "pass", "draw", "surface", "first"));
        this.mark();
        this.read(state.x, state.y);
    }

    async show() {
        const { frame } = this, pass = frame.passes[state.pass];
        if (!pass.targets.some((target) => target.surface === state.surface)) {
            const colour = pass.targets.find((target) => target.slot === "0") ?? pass.targets[0];
            state.surface = colour?.surface ?? 0;
            state.channel = "";
        }
        this.surfaces.replaceChildren(...pass.targets.map((target) => h("option", {
            value: target.surface, selected: target.surface === state.surface },
            `${target.slot === "depth" ? "depth" : `target ${target.slot}`}, ${frame.surfaces[target.surface].format}`)));
        this.surfaces.value = state.surface;
        this.image = await frame.targets.after(state.surface, frame.stop_of(state.pass, state.draw));
        const all = ways(this.image);
        if (!all.some(([key]) => key === state.channel))
            state.channel = all[0][0];
        this.ways.replaceChildren(...all.map(([key, text]) => h("option", { value: key }, text)));
        this.ways.value = state.channel;
        const range = paint(this.canvas, this.image, state.channel) ?? this.image.range(0);
        const { width, height } = this.image.surface;
        this.canvas.setAttribute("aria-label", `${frame.surfaces[state.surface].name}, ${width} by ${height}, after draw ${state.draw}`);
        this.below.replaceChildren(
            histogram(range),
            h("p", { class: "note" }, state.channel ? channel_names[state.channel] : "red", " from ",
              h("span", { class: "v" }, num(range.low)), " to ", h("span", { class: "v" }, num(range.high)),
              range.odd ? `; ${range.odd} values are not finite: striped` : ""));
        this.resize();
    }

    resize() {
        const zoom = Number(this.zoom.value), { width: across, height: down } = this.canvas;
        // where it fits, no higher than leaves room for the units below
        const width = zoom ? `${zoom * across / devicePixelRatio}px` : `min(100%, ${(50 * across / down).toFixed(2)}vh)`;
        for (const one of [this.canvas, this.over, this.cross, ...this.also])
            one.style.width = width;
        this.cross.setAttribute("viewBox", `0 0 ${this.canvas.width} ${this.canvas.height}`);
        this.mark();
    }

    async lay_over(paint_too) {
        const chosen = overlays[state.overlay] ?? overlays.none;
        this.overlay.value = state.overlay;
        if (!paint_too && !chosen.follows)
            return;
        this.over.width = this.canvas.width;
        this.over.height = this.canvas.height;
        this.legend.replaceChildren(...[await chosen.paint(this.over, this.frame, state, this.image) ?? ""].flat());
    }

    // The chosen pixel, and those that are recorded whole.
    mark() {
        const { width, height } = this.canvas, pass = this.frame.passes[state.pass];
        const unit = width / (this.canvas.clientWidth || width); // a pixel of the screen
        const line = (d, stroke, size) => svg("path", { d, stroke, "stroke-width": size * unit, fill: "none" });
        const { x, y } = state, gap = 7 * unit;
        const rays = `M${x + .5} ${y - gap}v${-3 * gap}M${x + .5} ${y + 1 + gap}v${3 * gap}M${x - gap} ${y + .5}h${-3 * gap}M${x + 1 + gap} ${y + .5}h${3 * gap}M${x} ${y}h1v1h-1z`;
        const same = pass.width === width && pass.height === height;
        const dots = this.recorded.checked && same
            ? pass.histories.pixels.map(([px, py]) => `M${px + .5 - unit} ${py + .5}h${2 * unit}M${px + .5} ${py + .5 - unit}v${2 * unit}`).join("") : "";
        this.cross.replaceChildren(line(dots, "#000", 2.6), line(dots, "#ff0", 1), line(rays, "#000", 3.4), line(rays, "#fff", 1.4));
    }
}
