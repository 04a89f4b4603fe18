// The rows that `lvsm_client_rows write` has left in /rows/, for a page to run.
export async function bytes(url) {
    const response = await fetch(url);
    if (!response.ok)
        throw new Error(`${url}: ${response.status}`);
    return response.arrayBuffer();
}

export async function text(url) {
    return new TextDecoder().decode(await bytes(url));
}

// run: from a row and the words of its inputs to the numbers of its results, in the order of the inputs.
export async function runRows(run) {
    for (const row of JSON.parse(await text("/rows/rows.json"))) {
        const words = new Uint32Array(await bytes(`/rows/${row.function}.inputs`));
        await fetch(`/rows/${row.function}.results`, {method: "PUT", body: await run(row, words)});
    }
}
