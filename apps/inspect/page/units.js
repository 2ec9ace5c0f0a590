// The units as panels, in the pipeline's order: a table of makers, each in a file of its own.

import { h } from "page/element.js";
import { json } from "page/data.js";
import { pixel } from "page/pixel.js";
import { choose, on_change, state } from "page/state.js";
import { assembly } from "page/panels/assembly.js";
import { blending } from "page/panels/blending.js";
import { clipping } from "page/panels/clipping.js";
import { draw } from "page/panels/draw.js";
import { interpolation } from "page/panels/interpolation.js";
import { quads } from "page/panels/quads.js";
import { raster } from "page/panels/raster.js";
import { setup } from "page/panels/setup.js";
import { shader } from "page/panels/shader.js";
import { tests } from "page/panels/tests.js";
import { vertex } from "page/panels/vertex.js";
import { viewport } from "page/panels/viewport.js";
import { technique_panels } from "page/techniques/all.js";

/** Each: id, title, says (three sentences), formula, rules (of CONVENTIONS.md), source (a path, or of(context)), needs
 * ("draw", "primitive" or "pixel": what has to be recorded), make(context): its content. Those of
 * techniques have applies(context) too: whether there is anything for them to show. */
export const units = [draw, assembly, vertex, clipping, viewport, setup, raster, interpolation, quads, shader, tests, blending];

const unit_needs = {
    assembly: [], vertex: [], clipping: [], viewport: [], setup: [], raster: [], draw: [],
    interpolation: ["interpolate varyings", "interpolate depth"], quads: ["whole quads"], shader: ["pixel shader"],
    tests: ["scissor", "alpha test", "stencil", "depth test", "depth write"], blending: ["colour write"],
};

function is_idle(unit, of) {
    const names = unit_needs[unit.id] ?? [];
    return of && names.length > 0 && names.every((name) => !of.units.find((row) => row.unit === name)?.runs);
}

async function source_details(frame, path) {
    const box = h("details", { class: "no-print" }, h("summary", {}, path));
    box.addEventListener("toggle", async () => {
        if (!box.open || box.children.length > 1)
            return;
        const text = (await json(frame.sources))[path] ?? "This file is not in the page.";
        box.append(h("pre", { class: "source", tabindex: 0 }, text.split("\n").map(
            (line, i) => h("span", { class: "line" }, h("span", { class: "n" }, i + 1), line + "\n"))));
    });
    return box;
}

// What there is to be said where something is not recorded, or not there.
function missing(unit, context) {
    if (!context.fragment && unit.needs !== "draw")
        return h("p", {}, "No triangle is at this pixel: choose another.");
    if (context.fragment?.verdict >= 8 && unit.needs === "pixel")
        return h("p", {}, "This triangle came no further: it has no fragment here.");
    if (unit.needs === "primitive" && !context.primitive)
        return h("p", { class: "callout" }, "The values of this triangle are not in the page: press n for the nearest pixel that is recorded whole.");
    if (unit.needs === "pixel" && !context.one)
        return h("p", { class: "callout" }, "The values of this pixel are not in the page: press n for the nearest pixel that is recorded whole.");
    if (["interpolation", "quads", "shader"].includes(unit.id) && !context.one?.interpolate)
        return h("p", {}, "A clip plane cut this fragment away before it had any values.");
    return null;
}

export function context_of(frame) {
    const fragment = pixel.list[state.fragment];
    const of = frame.draw_of(state.pass, fragment ? fragment.draw : state.draw);
    const part = (pixel.one?.raster ?? pixel.one?.missed)?.part ?? 0;
    return { frame, draw: of, pass: frame.passes[state.pass], fragment, one: pixel.one, primitive: pixel.primitive,
             setup: pixel.primitive?.setup[part] ?? pixel.primitive?.setup[0] };
}

/** The units, and the panels of techniques that have something to show. */
export function shown_units(frame) {
    const context = context_of(frame);
    return [...units, ...technique_panels.filter((one) => one.applies(context))];
}

async function show(frame, panel) {
    const context = context_of(frame), all = shown_units(frame);
    const unit = all.find((one) => one.id === state.unit) ?? units[0];
    const of = unit.id === "draw" ? frame.draw_of(state.pass, state.draw) : context.draw;
    const content = missing(unit, context) ?? await unit.make({ ...context, draw: of });
    panel.setAttribute("aria-labelledby", `tab-${unit.id}`);
    panel.replaceChildren(
        h("header", {}, h("h2", {}, unit.title),
          h("span", { class: "note" }, of ? `draw ${of.draw}${of.name ? `, ${of.name}` : ""}` : "",
            unit.id !== "draw" && context.fragment ? `, triangle ${context.fragment.primitive}, pixel ${state.x}, ${state.y}` : "")),
        h("div", { class: "says" }, unit.says.map((text) => h("p", {}, text)),
          unit.formula && h("div", { class: "formula", tabindex: 0 }, unit.formula),
          unit.rules && h("p", { class: "note" }, `Rules: ${unit.rules} in pipeline/CONVENTIONS.md`),
          await source_details(frame, typeof unit.source === "function" ? unit.source(context) : unit.source)),
        h("div", { class: "content" }, content));
    for (const one of panel.querySelectorAll("[data-scroll]")) { // what its box shall show
        const box = one.closest(".source, .list");
        box.scrollTop = one.getBoundingClientRect().top - box.getBoundingClientRect().top - box.clientHeight / 3;
    }
}

export function make_units(frame, strip, panel) {
    [...units, ...technique_panels].forEach((unit, i) => {
        strip.append(i ? h("span", { class: "arrow", "aria-hidden": "true" }, "\u203a") : "",
                     h("button", { type: "button", role: "tab", id: `tab-${unit.id}`, "aria-controls": "panel",
                                   onclick: () => choose({ unit: unit.id }) }, unit.tab ?? unit.title));
    });
    on_change(async () => {
        const context = context_of(frame), of = context.draw;
        for (const unit of technique_panels) {
            const tab = strip.querySelector(`#tab-${unit.id}`), applies = unit.applies(context);
            tab.hidden = tab.previousElementSibling.hidden = !applies;
            tab.setAttribute("aria-selected", String(unit.id === state.unit));
        }
        for (const unit of units) {
            const tab = strip.querySelector(`#tab-${unit.id}`), idle = Boolean(is_idle(unit, of));
            tab.setAttribute("aria-selected", String(unit.id === state.unit));
            tab.tabIndex = unit.id === state.unit ? 0 : -1;
            tab.classList.toggle("idle", idle);
            tab.title = idle ? "this draw leaves it out" : "";
        }
        await show(frame, panel);
    });
}
