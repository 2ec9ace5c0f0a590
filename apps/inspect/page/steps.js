// A shader's steps as a debugger shows them: instructions with operands, results, and the text they come from.

import { h, num, swatch, table, value } from "page/element.js";
import { json } from "page/data.js";
import { choose, state } from "page/state.js";

const INPUT = 1, UNIFORM = 2, NUMBER = 3, PIXEL = 4, FACE = 5, UNSET = 6;
const letters = "xyzw";

// Where an operand's component comes from: its name, and its value in this lane.
function part_of(part, names, results, own) {
    const [source, index, component, negated, constant] = part;
    const sign = (of) => negated && typeof of === "number" ? -of : of;
    switch (source) {
    case INPUT: return { name: names.inputs[index] ?? `in[${index}]`, of: sign(own.inputs[index]), negated };
    case UNIFORM: return { name: names.uniforms[index] ?? `c[${index}]`, of: constant, negated };
    case NUMBER: return { name: num(constant), of: constant, negated: false };
    case PIXEL: return { name: `vpos.${letters[index]}`, of: sign(own.place[index]), negated };
    case FACE: return { name: "vface", of: sign(own.face), negated };
    case UNSET: return { name: "unset", of: "unset", negated };
    default: return { name: `r${index}.${letters[component]}`, of: sign(results[index][component]), negated };
    }
}

// "r12.xyz" instead of three names, "-normal.xyz" likewise.
function joined(parts) {
    const stems = parts.map(({ name }) => name.replace(/\.[xyzw]$/, ""));
    const sign = parts[0].negated ? "\u2212" : "";
    if (parts.every((one) => one.name === parts[0].name && one.negated === parts[0].negated))
        return sign + parts[0].name;
    const ends = parts.map(({ name }) => name.match(/\.([xyzw])$/)?.[1]);
    if (stems.every((stem) => stem === stems[0]) && parts.every((one) => one.negated === parts[0].negated))
        return ends.every(Boolean) ? `${sign}${stems[0]}.${ends.join("")}` : sign + stems[0];
    return `(${parts.map((one) => (one.negated ? "\u2212" : "") + one.name).join(", ")})`;
}

// What inputs and uniforms are called. inputs: [{ name, components }], of vertices or varyings.
function names_of(draw, inputs) {
    const uniforms = [];
    for (const one of draw.uniforms ?? [])
        for (let i = 0; i < one.words; i++)
            uniforms[one.word + i] = one.words === 1 ? one.name : one.words <= 4 ? `${one.name}.${letters[i]}` : `${one.name}[${Math.floor(i / 4)}].${letters[i % 4]}`;
    return { uniforms, inputs: inputs.flatMap((input) => Array.from({ length: input.components },
        (_, c) => input.components > 1 ? `${input.name}.${letters[c]}` : input.name)) };
}

// A listing with the values of one lane: steps with operands [{ text, values }] and results.
function with_values(listing, steps, names, own) {
    const results = [];
    let at = 0;
    return listing.steps.map((step, number) => {
        const operands = step.operands.map((parts) => {
            const all = parts.map((part) => part_of(part, names, results, own));
            return { text: joined(all), values: all.map((one) => one.of) };
        });
        const from = at;
        results.push(steps.values.slice(from, at += step.width));
        return { ...step, number, operands, result: results[number], from };
    });
}

/** What a shader watches: [{ name, of, path }] in order, of: numbers; path: of each in the record. Steps that are left out have their
 * watches all the same; listing: null then. */
export function watched(listing, steps) {
    let at = 0;
    return ((listing ?? steps)?.watches ?? []).map(([name, width]) => {
        const from = at;
        return { name, of: steps.watched.slice(from, at += width), path: (c) => `steps.watched.${from + c}` };
    });
}

/** The listing of a pixel's or vertex's steps; null: there is none. */
export async function listing_of(pass, steps) {
    return steps && "listing" in steps ? (await json(pass.histories.listings))[steps.listing] : null;
}

function mask_text(step, of) {
    return ["<", "<=", ">", ">=", "==", "!=", "and", "or", "xor", "not"].includes(step.op) ? (of ? "true" : "false") : null;
}

function result_of(step, path) {
    if (!step.width)
        return "";
    const mask = mask_text(step, step.result[0]);
    return mask ? h("span", { class: "v", "data-path": `${path}.values.${step.from}`, "data-value": String(step.result[0]) }, mask)
        : step.width === 1 ? value(step.result[0], `${path}.values.${step.from}`)
        : h("span", { class: "vec" }, "(", step.result.map((one, i) => [i ? ", " : "", value(one, `${path}.values.${step.from + i}`)]), ")");
}

function in_words(step) {
    return `${step.width ? `r${step.number} = ` : ""}${step.op}${step.slot >= 0 ? ` s${step.slot}` : ""} ${step.operands.map((one) => one.text).join(", ")}`;
}

// The instruction that is looked at: operands with their values, its result, what the quad is about.
function detail(step, steps, spent, path) {
    return h("div", {}, h("h3", {}, `Step ${step.number}: `, h("code", {}, in_words(step))),
        table(["operand", "is", "value"], step.operands.map((one, i) => [`${"abc"[i]}`, h("code", {}, one.text),
            h("span", { class: "vec" }, one.values.length > 1 ? "(" : "", one.values.map(num).join(", "), one.values.length > 1 ? ")" : "")])),
        step.width ? h("p", {}, "gives ", result_of(step, path), step.width > 2 ? [" ", swatch(step.result)] : "") : "",
        steps.lanes[step.number] ? [h("p", { class: "note" }, "Over the quad, its first operand is"),
            table(["", "left top", "right top", "left below", "right below"], steps.lanes[step.number].map((lane, c) => [letters[c], ...lane.map((one) => h("span", { class: "v" }, num(one)))]))] : "",
        h("p", { class: "note" }, `${step.slots} slot${step.slots === 1 ? "" : "s"}; ${spent} until here. ${step.file}:${step.line}`));
}

async function text_of(frame, step) {
    const sources = await json(frame.sources), text = sources[step.file];
    if (!text)
        return h("p", { class: "note" }, `${step.file} is not in the page.`);
    const lines = text.split("\n");
    return h("pre", { class: "source", tabindex: 0, "aria-label": step.file }, lines.map((line, i) => h("span", {
        class: i + 1 === step.line ? "line now" : "line", "data-scroll": i + 1 === step.line }, h("span", { class: "n" }, i + 1), line + "\n")));
}

function watch_table(listing, steps, path) {
    const all = watched(listing, steps);
    if (!all.length || all.length > 12) // more of them are a loop's, and told by a technique's panel
        return "";
    return [h("p", { class: "note" }, "What the shader watches:"), table(null, all.map((one) => [h("code", {}, one.name),
        h("span", { class: "vec" }, one.of.map((of, c) => [c ? ", " : "", value(of, `${path}.${one.path(c).slice(6)}`)]))]))];
}

/** The steps of one lane, to be gone through.
 * of: { frame, pass, draw }; steps: recorded; inputs: [{ name, components }] as the program declares them; own: { inputs (values), place,
 * face }; path: of the steps in the record; what: "pixel", "vertex" */
export async function debugger_of({ frame, pass, draw }, steps, inputs, own, path, what) {
    const listing = await listing_of(pass, steps);
    if (!listing)
        return h("p", { class: "callout" }, `Its ${steps.left_out} steps are left out, since the page would grow too large: `, h("code", {}, `--region ${state.x} ${state.y} 1 1 --pixels 1`), " has them.");
    const all = with_values(listing, steps, names_of(draw, inputs), own);
    const now = all[Math.min(state.step, all.length - 1)];
    if (!now)
        return h("p", {}, "It has no instruction: its outputs are its inputs or constants as they are.");
    let spent = 0;
    const totals = all.map((step) => spent += step.slots);
    const rows = all.map((step) => ({ cells: [String(step.number), h("code", {}, in_words(step)), result_of(step, path), String(step.slots)],
                                      properties: { class: step === now && "now", "data-scroll": step === now, "data-step": step.number, onclick: () => choose({ step: step.number }) } }));
    const list = h("div", { class: "list", tabindex: 0, "aria-label": "Steps: j and k go on and back" }, table(["step", "instruction", `result at this ${what}`, "slots"], rows));
    return [h("p", {}, steps.agrees ? h("span", { class: "good" }, "\u2714 ") : h("b", { class: "bad" }, "\u2716 "),
              `${all.length} steps, ${totals.at(-1)} slots; `, steps.agrees ? "the last values have the executor's bits." : "the last values differ from the executor's."),
            h("div", { class: "debug" }, h("div", {}, list, watch_table(listing, steps, path)), h("div", {}, detail(now, steps, totals[now.number], path), await text_of(frame, now)))];
}
