// The pixel shader, instruction by instruction, as a debugger steps.

import { h, num, swatch, table, value, vec } from "page/element.js";
import { json } from "page/data.js";
import { choose, state } from "page/state.js";

const INPUT = 1, UNIFORM = 2, NUMBER = 3, PIXEL = 4, FACE = 5, UNSET = 6;
const letters = "xyzw";

// Where an operand's component comes from: its name, and its value at this pixel.
function part_of(part, names, results, own) {
    const [source, index, component, negated, constant] = part;
    const sign = (of) => negated && typeof of === "number" ? -of : of;
    switch (source) {
    case INPUT: return { name: names.inputs[index] ?? `in[${index}]`, of: sign(own.varyings[index]), negated };
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
    if (parts.length === 1)
        return sign + parts[0].name;
    if (parts.every((one) => one.name === parts[0].name && one.negated === parts[0].negated))
        return sign + parts[0].name;
    const ends = parts.map(({ name }) => name.match(/\.([xyzw])$/)?.[1]);
    if (stems.every((stem) => stem === stems[0]) && parts.every((one) => one.negated === parts[0].negated))
        return ends.every(Boolean) ? `${sign}${stems[0]}.${ends.join("")}` : sign + stems[0];
    return `(${parts.map((one) => (one.negated ? "\u2212" : "") + one.name).join(", ")})`;
}

function names_of(draw) {
    const inputs = draw.varyings.flatMap((varying) => Array.from({ length: varying.components },
        (_, c) => varying.components > 1 ? `${varying.name}.${letters[c]}` : varying.name));
    const uniforms = [];
    for (const one of draw.uniforms ?? [])
        for (let i = 0; i < one.words; i++)
            uniforms[one.word + i] = one.words === 1 ? one.name : one.words <= 4 ? `${one.name}.${letters[i]}` : `${one.name}[${Math.floor(i / 4)}].${letters[i % 4]}`;
    return { inputs, uniforms };
}

/** A listing with the values of one pixel: steps with operands [{ text, values }] and results. */
export function with_values(listing, steps, draw, own) {
    const names = names_of(draw), results = [];
    let at = 0;
    return listing.map((step, number) => {
        const operands = step.operands.map((parts) => {
            const all = parts.map((part) => part_of(part, names, results, own));
            return { text: joined(all), values: all.map((one) => one.of) };
        });
        const from = at;
        results.push(steps.values.slice(from, at += step.width));
        return { ...step, number, operands, result: results[number], from };
    });
}

function mask_text(step, of) {
    return ["<", "<=", ">", ">=", "==", "!=", "and", "or", "xor", "not"].includes(step.op) ? (of ? "true" : "false") : null;
}

function result_of(step) {
    if (!step.width)
        return "";
    const mask = mask_text(step, step.result[0]);
    return mask ? h("span", { class: "v", "data-path": `steps.values.${step.from}`, "data-value": String(step.result[0]) }, mask)
        : step.width === 1 ? value(step.result[0], `steps.values.${step.from}`)
        : h("span", { class: "vec" }, "(", step.result.map((one, i) => [i ? ", " : "", value(one, `steps.values.${step.from + i}`)]), ")");
}

function in_words(step) {
    return `${step.width ? `r${step.number} = ` : ""}${step.op}${step.slot >= 0 ? ` s${step.slot}` : ""} ${step.operands.map((one) => one.text).join(", ")}`;
}

// The instruction that is looked at: operands with their values, its result, what the quad is about.
function detail(step, steps, spent) {
    return h("div", {}, h("h3", {}, `Step ${step.number}: `, h("code", {}, in_words(step))),
        table(["operand", "is", "value"], step.operands.map((one, i) => [`${"abc"[i]}`, h("code", {}, one.text),
            h("span", { class: "vec" }, one.values.length > 1 ? "(" : "", one.values.map(num).join(", "), one.values.length > 1 ? ")" : "")])),
        step.width ? h("p", {}, "gives ", result_of(step), step.width > 2 ? [" ", swatch(step.result)] : "") : "",
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

export const shader = {
    id: "shader", title: "Pixel shader", needs: "pixel", source: "pipeline/units/pixel_stage.c", rules: "\u201cInstructions\u201d, R50 to R52",
    says: ["The pixel shader is a list of instructions on four-component registers; it has no branches that differ from pixel to pixel.",
           "Every step is the shader's own source, run again with recording lanes: what comes out has the bits that were drawn.",
           "Slots are what an instruction cost in the hardware of the time; registers are named after the step that wrote them."],
    make: async ({ frame, pass, draw, one, fragment }) => {
        if (!one.pixel)
            return h("p", {}, "This draw leaves its pixel shader out: nothing that it computes is kept.");
        const { color } = one.pixel;
        const gives = table(["target", "colour that the shader gives"], color.map((of, i) => [String(i), [swatch(of), vec(of, `pixel.color.${i}`)]]));
        if (!one.steps)
            return h("div", {}, gives, h("p", { class: "note" }, "This program was built without its counting lanes, which record steps."));
        if ("left_out" in one.steps)
            return h("div", {}, gives, h("p", { class: "callout" }, `Its ${one.steps.left_out} steps are left out, since the page would grow too large: `, h("code", {}, `--region ${state.x} ${state.y} 1 1 --pixels 1`), " has them."));
        const listing = (await json(pass.histories.listings))[one.steps.listing];
        const own = { varyings: one.interpolate.varyings, place: [state.x, state.y], face: one.raster.front ? 1 : -1 };
        const all = with_values(listing, one.steps, draw, own);
        const now = all[Math.min(state.step, all.length - 1)];
        let spent = 0;
        const totals = all.map((step) => spent += step.slots);
        if (!now)
            return h("div", {}, gives, h("p", {}, "It has no instruction: its outputs are interpolants or constants as they are."));
        const rows = all.map((step) => ({ cells: [String(step.number), h("code", {}, in_words(step)), result_of(step), String(step.slots)],
                                          properties: { class: step === now && "now", "data-scroll": step === now, "data-step": step.number, onclick: () => choose({ step: step.number }) } }));
        const list = h("div", { class: "list", tabindex: 0, "aria-label": "Steps: j and k go on and back" }, table(["step", "instruction", "result at this pixel", "slots"], rows));
        const source = await text_of(frame, now);
        return h("div", {}, h("p", {}, one.steps.agrees ? h("span", { class: "good" }, "\u2714 ") : h("b", { class: "bad" }, "\u2716 "),
                              `${all.length} steps, ${totals.at(-1) ?? 0} slots; `, one.steps.agrees ? "the last values have the executor's bits." : "the last values differ from the executor's.",
                              one.pixel.killed ? h("b", { class: "bad" }, " It kills this fragment.") : ""),
                 gives, h("div", { class: "debug" }, list, h("div", {}, detail(now, one.steps, totals[now.number]), source)));
    },
};
