// The blocks of data inside the page (apps/inspect/blobs.h).

const texts = new Map();

function bytes_of(number) {
    const text = document.getElementById(`blob-${number}`).textContent;
    const binary = atob(text), bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; i++)
        bytes[i] = binary.charCodeAt(i);
    return bytes;
}

/** A block, unpacked. */
export async function blob(number) {
    const stream = new Blob([bytes_of(number)]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A block that is JSON; kept, so that it is read once. */
export function json(number) {
    if (!texts.has(number))
        texts.set(number, blob(number).then((bytes) => JSON.parse(new TextDecoder().decode(bytes))));
    return texts.get(number);
}
