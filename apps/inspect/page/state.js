// What is chosen: one object, and who is told when it changes.

/** pass, draw (its targets are shown as they are after it), surface, x, y, fragment (number in the pixel's
 * list), unit (of the strip), step (of the shader), corner (of the
 * triangle, whose vertex shader is looked at), overlay. */
export const state = { pass: 0, draw: 0, surface: 0, channel: "", x: 0, y: 0, fragment: 0, unit: "draw", step: 0, corner: 0,
                       overlay: "none" };

const listeners = [];

export function on_change(listener) {
    listeners.push(listener);
}

let drawing = Promise.resolve();

/** Settles when all that was chosen has been drawn. */
export async function idle() {
    for (let seen = null; seen !== drawing;) {
        seen = drawing;
        await seen;
    }
}

/** Changes some of it, one change after the other. Settles when all have drawn it. */
export function choose(changes) {
    drawing = drawing.catch(() => {}).then(() => change(changes));
    return drawing;
}

async function change(changes) {
    const changed = Object.keys(changes).filter((key) => state[key] !== changes[key]);
    Object.assign(state, changes);
    if (changed.length)
        for (const listener of listeners)
            await listener(new Set(changed));
    const { pass, draw, x, y, unit } = state;
    history.replaceState(null, "", `#pass=${pass}&draw=${draw}&x=${x}&y=${y}&unit=${unit}`);
}

/** What the address asks for: "#pass=0&x=10&y=20". */
export function from_address() {
    const asked = new URLSearchParams(location.hash.slice(1)), changes = {};
    for (const key of ["pass", "draw", "x", "y", "fragment", "step", "corner"])
        if (asked.has(key))
            changes[key] = Number(asked.get(key));
    for (const key of ["unit", "overlay"])
        if (asked.has(key))
            changes[key] = asked.get(key);
    return changes;
}
