// Set-up and culling: the triangle's area, its facing, and its edges.

import { h, num, svg, table, value } from "page/element.js";

/** The triangle as an SVG path, in pixels. */
export function outline(setup) {
    return "M" + [0, 1, 2].map((i) => `${setup.x[i] / 256} ${setup.y[i] / 256}`).join("L") + "Z";
}

function picture(setup) {
    const xs = setup.x.map((x) => x / 256), ys = setup.y.map((y) => y / 256);
    const left = Math.min(...xs), top = Math.min(...ys), width = Math.max(...xs) - left || 1, height = Math.max(...ys) - top || 1;
    const scale = Math.min(360 / width, 240 / height), X = (x) => 40 + (x - left) * scale, Y = (y) => 30 + (y - top) * scale;
    const middle = [xs.reduce((a, b) => a + b) / 3, ys.reduce((a, b) => a + b) / 3];
    const colors = ["var(--a)", "var(--b)", "var(--c)"], dashes = ["", "8 4", "2 4"];
    return svg("svg", { viewBox: `0 0 ${80 + width * scale} ${60 + height * scale}`, width: Math.min(460, 80 + width * scale), role: "img",
                        "aria-label": `Triangle that turns ${setup.area2 > 0 ? "clockwise" : "counter-clockwise"}` },
        svg("path", { class: "tri", style: "stroke: none", d: "M" + xs.map((x, i) => `${X(x)} ${Y(ys[i])}`).join("L") + "Z" }),
        [0, 1, 2].map((i) => {
            const from = (i + 1) % 3, to = (i + 2) % 3;
            return svg("line", { x1: X(xs[from]), y1: Y(ys[from]), x2: X(xs[to]), y2: Y(ys[to]), stroke: colors[i], "stroke-width": 2.5, "stroke-dasharray": dashes[i] });
        }),
        xs.map((x, i) => svg("text", { x: X(x) + (x < middle[0] ? -22 : 8), y: Y(ys[i]) + (ys[i] < middle[1] ? -6 : 16) }, `v${i}`)),
        svg("text", { x: X(middle[0]) - 8, y: Y(middle[1]) + 6, style: "font-size: 22px" }, setup.area2 > 0 ? "\u21bb" : "\u21ba"));
}

export const setup = {
    id: "setup", title: "Set-up", needs: "primitive", source: "pipeline/units/setup.c", rules: "R4, R5, R8, R16, R22",
    says: ["Set-up finds what stays the same inside a triangle: its area, which way it turns, and the equation of each edge.",
           "A triangle that turns the culled way, has no area, or holds no pixel centre, ends here.",
           "An edge's value is 0 on the edge, grows inward, and is an exact whole number: no two triangles ever disagree about a pixel between them."],
    formula: "2A = (x\u2081\u2212x\u2080)(y\u2082\u2212y\u2080) \u2212 (x\u2082\u2212x\u2080)(y\u2081\u2212y\u2080)\n2A > 0: clockwise, front\nE\u1d62(x, y) = a x + b y + c,  E\u2080 + E\u2081 + E\u2082 = |2A|",
    make: ({ setup: one, primitive, draw }) => {
        if (!one)
            return h("p", {}, primitive.clip?.corners === 0 ? "Clipping left nothing of this triangle." : "A point needs no set-up but its square (R12).");
        const path = `setup.${one.part}`, area = Math.abs(one.area2) / 131072;
        const colors = ["red, whole line", "green, dashes", "blue, dots"];
        return h("div", { class: "cols" },
            h("div", {},
              h("p", {}, "2A = ", value(one.area2, `${path}.area2`), ` in 1/65536 of a pixel: ${num(area)} pixels, turning `,
                h("b", {}, one.area2 > 0 ? "clockwise: front" : one.area2 < 0 ? "counter-clockwise: back" : "no way at all"), `; this draw culls ${draw.state.cull === "none" ? "nothing" : draw.state.cull}.`),
              one.culled ? h("p", { class: "callout" }, h("b", { class: "bad" }, "\u2716 not drawn: "), { facing: "it faces the culled way.", "zero area": "snapped to 1/256 pixel, it has no area.", "no pixel centre inside": "no pixel centre is inside its bounds." }[one.reason] ?? one.reason) : "",
              one.edges ? table(["edge", "opposite", "a", "b", "c", "a centre on it"], one.edges.map((edge, i) => [
                  colors[i], `v${i}`, value(edge.a, `${path}.edges.${i}.a`), value(edge.b, `${path}.edges.${i}.b`), value(edge.c, `${path}.edges.${i}.c`),
                  edge.accepts_zero ? h("b", {}, "\u25cf is inside: top or left") : "\u25cb is outside"])) : ""),
            h("figure", {}, picture(one), h("figcaption", {}, "As it lies on the screen, y downward.")));
    },
};
