// Elements in few words. Text is always text: nothing here reads HTML.

type Attributes = Record<string, string | number | boolean | null | undefined>;
type Child = Node | string | null | undefined;

export function el<Name extends keyof HTMLElementTagNameMap>(
    name: Name,
    attributes: Attributes = {},
    ...children: Child[]
): HTMLElementTagNameMap[Name] {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        const isSaid = key.startsWith("aria-"); // there false says something
        if (value === null || value === undefined || (value === false && !isSaid)) continue;
        element.setAttribute(key, value === true && !isSaid ? "" : String(value));
    }
    for (const child of children) if (child !== null && child !== undefined) element.append(child);
    return element;
}

export function button(label: string, name: string, onClick: () => void): HTMLButtonElement {
    const element = el("button", { type: "button", title: name, "aria-label": name }, label);
    element.addEventListener("click", onClick);
    return element;
}

/** A select with its label. Options are [value, text]. */
export function choice(
    label: string,
    options: [string, string][],
    value: string,
    onChange: (value: string) => void,
): HTMLLabelElement {
    const select = el("select", { "aria-label": label });
    setOptions(select, options, value);
    select.addEventListener("change", () => onChange(select.value));
    return el("label", { class: "choice" }, el("span", {}, label), select);
}

export function setOptions(select: HTMLSelectElement, options: [string, string][], value: string): void {
    select.replaceChildren(...options.map(([key, text]) => el("option", { value: key }, text)));
    select.value = options.some(([key]) => key === value) ? value : (options[0]?.[0] ?? "");
}

export function checkbox(
    label: string,
    checked: boolean,
    onChange: (checked: boolean) => void,
): HTMLLabelElement {
    const input = el("input", { type: "checkbox" });
    input.checked = checked;
    input.addEventListener("change", () => onChange(input.checked));
    return el("label", { class: "check" }, input, el("span", {}, label));
}

/** Gives a file to the user. */
export function download(name: string, contents: Blob): void {
    const address = URL.createObjectURL(contents);
    const link = el("a", { href: address, download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** A name that every file system takes. */
export function fileName(...parts: string[]): string {
    return parts
        .join("-")
        .replace(/[^A-Za-z0-9._=-]+/g, "_")
        .slice(0, 100);
}
