// Clipping: how the triangle lies in the clip volume, and what is left of it.

import { h, svg, table, value, vec } from "page/element.js";

const planes = ["left", "right", "bottom", "top", "near", "far"];

function picture(clip) {
    const known = clip.clip.filter((p) => p[3] > 0), w = 420, hh = 236;
    const all = [...known, ...clip.polygon].map((p) => [p[2], p[3]]);
    const most = Math.max(1e-9, ...all.map(([z, q]) => Math.max(Math.abs(z), Math.abs(q)))) * 1.15;
    const X = (z) => 60 + (z / most + .25) / 1.25 * (w - 80), Y = (q) => hh - 30 - Math.max(-.1, q / most) * (hh - 50);
    const dot = (p, text, kind) => [svg("circle", { cx: X(p[2]), cy: Y(p[3]), r: 4, fill: kind }), svg("text", { x: X(p[2]) + 7, y: Y(p[3]) - 5 }, text)];
    return h("figure", {}, svg("svg", { viewBox: `0 0 ${w} ${hh}`, width: w, role: "img", "aria-label": "The corners by z and w, with the near and far planes" },
        svg("path", { class: "frame", d: `M${X(0)} ${Y(0)}L${X(0)} ${Y(most)}L${X(most)} ${Y(most)}Z`, style: "fill: var(--tint)" }),
        svg("text", { x: X(0) - 52, y: Y(most * .75) }, "near z = 0"), svg("text", { x: X(most * .62) + 14, y: Y(most * .62) + 14 }, "far z = w"),
        svg("path", { class: "tri", d: "M" + clip.clip.map((p) => `${X(p[2])} ${Y(p[3])}`).join("L") + "Z" }),
        clip.clip.map((p, i) => dot(p, `v${i}`, "var(--accent)")),
        clip.polygon.length > 0 && clip.planes ? clip.polygon.map((p, i) => svg("rect", { x: X(p[2]) - 3, y: Y(p[3]) - 3, width: 6, height: 6, fill: "none", stroke: "var(--mark)", "stroke-width": 2 })) : "",
        svg("text", { x: w - 34, y: hh - 12 }, "z"), svg("text", { x: 8, y: 16 }, "w"),
        svg("path", { class: "axis", d: `M${X(-most * .25)} ${Y(0)}H${w - 10}` })),
        h("figcaption", {}, "The corners seen from the side: z to the right, w upward; inside is shaded. Squares are corners that clipping left."));
}

export const clipping = {
    id: "clipping", title: "Clipping", tab: "Clip", needs: "primitive", source: "pipeline/units/clip.c", rules: "R3, R10, R11",
    says: ["Clipping cuts away what is in front of the near plane, behind the far one, or so far aside that fixed point could not hold it.",
           "A triangle that merely leaves the picture is not cut: the guard band is much wider than the viewport, and the rasterizer takes care of the rest.",
           "A new corner lies on an edge, t of the way from its inside end to its outside end, so that neighbours are cut at the same point."],
    formula: "near  d = z        far   d = w \u2212 z\nleft  d = x \u2212 l w   right d = r w \u2212 x   (guard band)\nt = d\u1d62\u2099 / (d\u1d62\u2099 \u2212 d\u2092\u1d64\u209c)\ncorner = inside + t (outside \u2212 inside)",
    make: ({ primitive }) => {
        const clip = primitive.clip;
        if (!clip)
            return h("p", {}, "A point is not cut: its vertex is inside the near and far planes, or it is not drawn.");
        const crossed = planes.filter((_, i) => clip.planes >> i & 1);
        return h("div", {},
            h("p", {}, crossed.length ? ["Some corner is outside of ", h("b", {}, crossed.join(", ")), "; ", value(clip.corners, "clip.corners"), clip.corners ? " corners are left." : " corners are left: nothing is drawn."]
                                      : ["All corners are inside of all planes: the triangle goes on as it is, with ", value(clip.corners, "clip.corners"), " corners."]),
            picture(clip),
            table(["corner", "x, y, z, w", "inside near (z \u2265 0)", "inside far (z \u2264 w)"], clip.clip.map((p, i) => [
                `v${i}`, vec(p, `clip.clip.${i}`), p[2] >= 0 ? "yes" : h("b", { class: "bad" }, "\u2716 no"), p[2] <= p[3] ? "yes" : h("b", { class: "bad" }, "\u2716 no")])),
            crossed.length && clip.polygon.length ? [h("h3", {}, "Corners that are left, a fan round the first"),
                table(["corner", "x, y, z, w"], clip.polygon.map((p, i) => [String(i), vec(p, `clip.polygon.${i}`)]))] : "",
            h("p", { class: "note" }, "Guard band, as x/w and y/w: left ", value(clip.band[0], "clip.band.0"), ", right ", value(clip.band[1], "clip.band.1"),
              ", bottom ", value(clip.band[2], "clip.band.2"), ", top ", value(clip.band[3], "clip.band.3"), "."));
    },
};
