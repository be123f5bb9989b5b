/** Undo and redo stacks of immutable states. */
export class UndoHistory<T> {
  private past: T[] = [];
  private future: T[] = [];
  private stroke: string | null = null;

  /** Pushes the state before a change. Consecutive changes with the same `stroke`, as of a held key, are one step. */
  push(before: T, stroke: string | null = null): void {
    if (stroke === null || stroke !== this.stroke) this.past.push(before);
    if (this.past.length > MAX_STEPS) this.past.shift();
    this.stroke = stroke;
    this.future = [];
  }

  /** Ends the current stroke: the next change is a new undo step. */
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

const MAX_STEPS = 200;
