import { listen } from "../../kit/listen";

/** Keys pressed within this time form one prefix of a name. */
const TYPING_MS = 1000;
const HIGHLIGHT = "blocklyMenuItemHighlight";

/** A Blockly menu, whose own keys move through a single column. */
interface Menu {
  highlightNext(): void;
  highlightPrevious(): void;
}

/**
 * Makes a menu in rows usable by keyboard: four arrow keys, and typing the start of a name. Returns
 * a function that removes the key handler.
 */
export function steerByKeys(content: HTMLElement, menu: Menu): () => void {
  let typed = "";
  let typedAt = 0;
  const find = (key: string, now: number) => {
    typed = now - typedAt < TYPING_MS ? typed + key : key;
    typedAt = now;
    const prefix = typed.toLowerCase();
    return itemsIn(content).find((item) => nameOf(item).toLowerCase().startsWith(prefix));
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const isTyped = event.key.length === 1 && event.key !== " ";
    const items = itemsIn(content);
    const to = isTyped ? find(event.key, event.timeStamp) : beside(items, event.key);
    if (!to) return;
    event.preventDefault();
    event.stopPropagation();
    for (
      let steps = items.indexOf(to) - highlighted(items);
      steps !== 0;
      steps -= Math.sign(steps)
    ) {
      if (steps > 0) menu.highlightNext();
      else menu.highlightPrevious();
    }
  };
  return listen(content, { keydown: onKey }, { capture: true });
}

function itemsIn(content: HTMLElement): HTMLElement[] {
  return [...content.querySelectorAll<HTMLElement>(".blocklyMenuItem")];
}

function highlighted(items: readonly HTMLElement[]): number {
  return items.findIndex((item) => item.classList.contains(HIGHLIGHT));
}

function nameOf(item: HTMLElement): string {
  return item.textContent?.trim() ?? "";
}

/** The item that an arrow key selects from the highlighted item. */
function beside(items: readonly HTMLElement[], key: string): HTMLElement | undefined {
  const at = highlighted(items);
  const from = items[at];
  if (!from) return undefined;
  if (key === "ArrowRight") return items[at + 1];
  if (key === "ArrowLeft") return items[at - 1];
  const here = from.getBoundingClientRect();
  const middle = here.left + here.width / 2;
  const rows = (isBeyond: (top: number) => boolean) =>
    items.filter((item) => isBeyond(item.getBoundingClientRect().top));
  if (key === "ArrowDown")
    return nearest(
      rows((top) => top > here.top + 1),
      middle,
      1,
    );
  if (key === "ArrowUp")
    return nearest(
      rows((top) => top < here.top - 1),
      middle,
      -1,
    );
  return undefined;
}

/** The item of the next row that is horizontally nearest to `middle`, in pixels. */
function nearest(
  items: readonly HTMLElement[],
  middle: number,
  direction: 1 | -1,
): HTMLElement | undefined {
  const places = items.map((item) => ({ item, box: item.getBoundingClientRect() }));
  const row = Math.min(...places.map(({ box }) => direction * box.top));
  const away = ({ box }: { box: DOMRect }) => Math.abs(box.left + box.width / 2 - middle);
  return places
    .filter(({ box }) => direction * box.top < row + 1)
    .sort((one, other) => away(one) - away(other))[0]?.item;
}
