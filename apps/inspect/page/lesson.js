// A lesson's question (apps/inspect/lesson_answer.h has its data): what it asks for is veiled until it is
// answered, or given up.

import { h } from "page/element.js";
import { json } from "page/data.js";
import { choose, state } from "page/state.js";
import { pixel } from "page/pixel.js";
import { units } from "page/units.js";

// What a lesson may hide by name, beside values, which it names by their paths.
const parts = {
    history: "#pixel .fragments", readout: ".readout [data-stored]",
    counters: ".funnel, #events .amount", chosen: "#panel > header .note", figure: "#panel .content figure, #panel .content svg",
    notes: "#panel .content .note", words: "#panel .content p", steps: "#panel .debug",
};

const keep = (name, how) => {
    try {
        localStorage.setItem(`glasspipe lesson ${name}`, how);
    } catch {
        // a browser that keeps nothing for files: the index then marks nothing
    }
};

/** FNV-1a of 64 bits, as 16 digits, of a text's UTF-8. */
export function hash_of(text) {
    let hash = 0xcbf29ce484222325n;
    for (const byte of new TextEncoder().encode(text))
        hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    return hash.toString(16).padStart(16, "0");
}

// "0x80", ".5", "0,5", "-3", "1/2"; NaN for all else.
function number_of(word) {
    const text = word.replace(/\u2212/g, "-").replace(",", ".").replace(/^\+/, "");
    if (/^-?0x[0-9a-f]+$/i.test(text))
        return text[0] === "-" ? -Number(text.slice(1)) : Number(text);
    const ratio = text.match(/^(-?\d*\.?\d+)\/(\d*\.?\d+)$/);
    if (ratio)
        return Number(ratio[1]) / Number(ratio[2]);
    return /^-?(\d+\.?\d*|\.\d+)(e-?\d+)?$/i.test(text) ? Number(text) : NaN;
}

/** The normal form of an answer; null: it is none of this form. */
export function normal_form(lesson, text) {
    if (lesson.form === "choice")
        return text;
    const words = lesson.form === "set" ? text.split(/[\s,;]+|\band\b/).filter(Boolean) : [text.replace(/\s+/g, "")];
    const values = words.map(number_of).map((one) => one * 10 ** lesson.places);
    if (!values.length || values.some((one) => !Number.isFinite(one)) ||
        (lesson.form !== "decimal" && values.some((one) => !Number.isInteger(one))))
        return null;
    const whole = values.map((one) => Math.sign(one) * Math.floor(Math.abs(one) + .5) + 0);
    return [...new Set(whole)].sort((a, b) => a - b).join(" ");
}

const forms = {
    whole: [() => "A whole number; 0x before hexadecimal digits", "a whole number, such as 12 or 0xc"],
    decimal: [(places) => `A number, to ${places} place${places === 1 ? "" : "s"}`, "a number, such as 0.25 or -3"],
    set: [() => "Whole numbers, in any order", "whole numbers, such as 1, 4"],
};

// Whether a value's path is one of a lesson's, or below it: words with dots between, * is any.
function hides(pattern, path) {
    const wanted = pattern.split("."), words = path.split(".");
    return wanted.length <= words.length && wanted.every((word, i) => word === "*" || word === words[i]);
}

class Veil {
    constructor(lesson) {
        this.paths = lesson.hide.filter((word) => !(word in parts));
        this.selector = lesson.hide.filter((word) => word in parts).map((word) => parts[word]).join(", ");
        this.at = units.findIndex((unit) => unit.id === lesson.unit);
        this.observer = new MutationObserver(() => this.lay());
    }

    lay() {
        if (!this.observer)
            return;
        for (const one of document.querySelectorAll("[data-path]"))
            if (this.paths.some((path) => hides(path, one.dataset.path)))
                for (const each of [one, ...one.parentElement.querySelectorAll(":scope > .note")]) // and what is said of it
                    each.classList.add("veiled");
        for (const one of this.selector ? document.querySelectorAll(this.selector) : [])
            one.classList.add(one.closest("figure, svg, .fragments, .funnel, .debug, p") === one ? "veiled-part" : "veiled");
        const panel = document.getElementById("panel"), content = panel.querySelector(".content");
        content?.classList.toggle("veiled-part", units.findIndex((unit) => unit.id === state.unit) > this.at);
    }

    begin() {
        this.observer.observe(document.body, { childList: true, subtree: true });
        this.lay();
    }

    lift() {
        this.observer.disconnect();
        this.observer = null;
        for (const one of document.querySelectorAll(".veiled, .veiled-part")) {
            one.classList.toggle("unveiled", one.matches(".content .veiled"));
            one.classList.remove("veiled", "veiled-part");
        }
    }
}

function links(lesson) {
    const all = [[lesson.previous, "\u2039 previous"], [lesson.index, "all lessons"], [lesson.next, "next \u203a"]];
    return h("nav", { "aria-label": "Lessons" }, all.map(([href, text]) => href && h("a", { href }, text)));
}

function entry(lesson) {
    if (lesson.form === "choice")
        return h("fieldset", {}, h("legend", { class: "unseen" }, "Your answer"), lesson.choices.map((one) => h("label", {},
            h("input", { type: "radio", name: "answer", value: one.value }), h("span", {}, one.text))));
    return h("label", {}, h("span", {}, "Your answer"), h("input", { type: "text", name: "answer", autocomplete: "off", spellcheck: "false",
        size: 12, "aria-describedby": "answer-form" }), h("span", { class: "note", id: "answer-form" }, forms[lesson.form][0](lesson.places)));
}

// The fragment that the lesson looks at, when its pixel is known.
const fragment_of = (lesson) => pixel.list.findIndex((one) => one.draw === lesson.draw && one.primitive === lesson.triangle);

function make_question(lesson, section, veil) {
    const said = h("div", { class: "said", role: "status" }), form = h("form", { novalidate: true });
    const settle = async (how) => {
        veil.lift();
        keep(lesson.name, how);
        form.querySelectorAll("input, button").forEach((one) => { one.disabled = true; });
        form.querySelector(".buttons").hidden = true;
        section.dataset.state = how;
        said.replaceChildren(h("p", {}, how === "answered" ? h("b", { class: "good" }, "\u2714 That is it. ") : h("b", {}, "\u25cb "), await json(lesson.why)),
            h("p", { class: "note" }, "The page shows the value now, with all units that come after it."));
    };
    form.addEventListener("submit", (event) => {
        event.preventDefault();
        const text = new FormData(form).get("answer")?.trim() ?? "", normal = text ? normal_form(lesson, text) : null;
        if (normal === null)
            said.replaceChildren(h("p", {}, lesson.form === "choice" ? "Choose one." : `Expected ${forms[lesson.form][1]}.`));
        else if (hash_of(`${lesson.name}\n${normal}`) === lesson.hash)
            settle("answered");
        else
            said.replaceChildren(h("p", {}, h("b", { class: "bad" }, "\u2716 Not that. "), lesson.hint ?? "Look again, and try once more."));
    });
    form.append(entry(lesson), h("div", { class: "buttons" }, h("button", { type: "submit", class: "main" }, "Check"),
        h("button", { type: "button", onclick: () => settle("shown") }, "Show me")), said);
    section.append(h("div", { class: "ask" }, h("h2", {}, "Question"), h("p", { class: "question" }, lesson.question), form),
        h("div", { class: "look" }, links(lesson), lesson.look.length ? [h("h2", {}, "Look at"), h("ul", {}, lesson.look.map((one) => h("li", {}, one)))] : ""));
    section.hidden = false;
    document.body.classList.add("asks");
}

/** The lesson of a page; null: it has none. */
export async function load_lesson(number) {
    return number >= 0 ? json(number) : null;
}

/** Where a lesson begins. */
export const begin_lesson = (frame, lesson) => lesson ? { pass: lesson.pass, draw: frame.passes[lesson.pass].draws.length - 1, x: lesson.x, y: lesson.y, unit: lesson.unit, step: lesson.step } : {};

/** Asks the question, when all else is shown. */
export async function make_lesson(lesson, section) {
    if (!lesson)
        return;
    await choose({ fragment: fragment_of(lesson) });
    const veil = new Veil(lesson);
    make_question(lesson, section, veil);
    veil.begin();
}
