// Alpha test, stencil, depth: who may write.

import { h, table, value } from "page/element.js";

const signs = { always: "always", never: "never", less: "<", equal: "=", "less-equal": "\u2264", greater: ">", "not-equal": "\u2260", "greater-equal": "\u2265" };

function codes(test, i) {
    return test.unit === "depth" ? [" as codes ", value(test.incoming_code, `test.${i}.incoming_code`), " and ", value(test.stored_code, `test.${i}.stored_code`)] : "";
}

export const tests = {
    id: "tests", title: "Tests", needs: "pixel", source: "pipeline/units/depth_stencil.c", rules: "R18 to R21, R30, R38, R39",
    says: ["A fragment is written only if it passes every test: the shader's own kill, scissor, alpha, stencil, depth, in this order.",
           "Depth is compared as the whole number that is stored, so that a surface drawn twice is equal to itself.",
           "Stencil counts or marks: its value may change even where the fragment goes no further."],
    formula: "passes: incoming TEST stored\nstencil: (reference & mask) TEST (stored & mask)",
    make: ({ draw, one }) => h("div", {},
        one.pixel?.killed ? h("p", { class: "callout" }, h("b", { class: "bad" }, "\u2716 killed"), " by its shader (texkill or discard): no test follows.") : "",
        one.tests.length ? table(["test", "incoming", "", "stored", "verdict", "stencil"], one.tests.map((test, i) => [
            test.unit, ["scissor", "clip plane"].includes(test.unit) ? "" : value(test.incoming, `test.${i}.incoming`), signs[test.compare] ?? test.compare,
            ["scissor", "clip plane"].includes(test.unit) ? "" : [value(test.stored, `test.${i}.stored`), codes(test, i)],
            test.passed ? h("b", { class: "good" }, "\u2714 passed", test.ternary ? `: ${test.ternary}` : "") : h("b", { class: "bad" }, "\u2716 failed"),
            "stencil_before" in test ? [value(test.stencil_before, `test.${i}.stencil_before`), " becomes ", value(test.stencil_after, `test.${i}.stencil_after`)] : ""]))
            : one.pixel?.killed ? "" : h("p", {}, "This draw has no test: every fragment goes on."),
        h("h3", {}, "How this draw tests"),
        table(null, ["scissor", "alpha test", "alpha reference", "stencil", "stencil reference", "depth test", "depth write"].filter((key) => key in draw.state).map((key) => [key, String(draw.state[key])]))),
};
