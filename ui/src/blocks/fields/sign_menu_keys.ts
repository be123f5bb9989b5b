import { listen } from "../../kit/listen";

/** What is typed within this time is one beginning of a name. */
const TYPING_MS = 1000;
const HIGHLIGHT = "blocklyMenuItemHighlight";

/** A menu of Blockly, whose own keys are those of a list. */
interface Menu {
  highlightNext(): void;
  highlightPrevious(): void;
}

/**
 * Keys of a menu that lies in rows: all four arrows, and the beginning of a name that is typed. Returns the function
 * that ends it.
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

/** The item where an arrow key leads from the highlighted one. */
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

/** Of the next row, the item that is nearest to a place across. */
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
