/** What was there before each change, and what was undone; states are never changed themselves. */
export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private stroke: string | null = null;

  /** Keeps the state before a change. Changes with one `stroke` after another, as of a held key, are undone as one. */
  keep(before: T, stroke: string | null = null): void {
    if (stroke === null || stroke !== this.stroke) this.past.push(before);
    if (this.past.length > MOST) this.past.shift();
    this.stroke = stroke;
    this.future = [];
  }

  /** Makes the next change one of its own, whatever its stroke. */
  rest(): void {
    this.stroke = null;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  undo(now: T): T {
    return this.step(this.past, this.future, now);
  }

  redo(now: T): T {
    return this.step(this.future, this.past, now);
  }

  private step(from: T[], to: T[], now: T): T {
    this.stroke = null;
    if (from.length === 0) return now;
    to.push(now);
    return from.pop() as T;
  }
}

const MOST = 200;
