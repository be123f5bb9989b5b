/**
 * Roving tabindex: the arrow keys move along a row of elements, of which only one is a Tab stop.
 * Without it a timeline with forty entries would have forty Tab stops.
 */
export function rove(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  const items = [...event.currentTarget.querySelectorAll<HTMLElement>("[data-rove]")];
  const at = items.indexOf(event.target as HTMLElement);
  const to = targetOf(event.key, at, items.length);
  const next = to === null ? undefined : items[to];
  if (at < 0 || !next) return;
  event.preventDefault();
  for (const item of items) item.tabIndex = item === next ? 0 : -1;
  next.focus();
}

function targetOf(key: string, at: number, count: number): number | null {
  if (key === "ArrowRight") return Math.min(count - 1, at + 1);
  if (key === "ArrowLeft") return Math.max(0, at - 1);
  if (key === "Home") return 0;
  return key === "End" ? count - 1 : null;
}
