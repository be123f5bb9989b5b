import { computed, effect, signal } from "@preact/signals";
import type { BlocksViewer } from "../editor/reader/viewer";
import { texts } from "../i18n";
import { problem } from "../shell/session";
import { differenceText } from "./difference_text";
import {
  type Compared,
  type ComparedWorkspaces,
  type Differing,
  differing,
  kindsOf,
} from "./differences";

/** The drawn blocks of two versions, their differences, and the selected difference. */
export class ComparedBlocks<Of extends ComparedWorkspaces = Compared> {
  readonly before = signal<BlocksViewer | null>(null);
  readonly after = signal<BlocksViewer | null>(null);
  /** Counts how often both sides were drawn. */
  readonly drawn = signal(0);
  /** Index of the selected difference in `list`; null if none is selected. */
  readonly chosen = signal<number | null>(null);
  /** The differing blocks, sorted from top to bottom. */
  readonly list = computed<Differing[]>(() => {
    const [first, second] = [this.before.value, this.after.value];
    if (this.drawn.value === 0 || !first || !second) return [];
    const height = ({ block, kinds }: Differing) =>
      (kinds.includes("removed") ? first : second).heightOf(block);
    return differing(this.compared.difference).sort((one, other) => height(one) - height(other));
  });
  /** Text of each difference, read from the blocks, which are redrawn when the language changes. */
  readonly lines = computed<string[]>(() => {
    const [first, second] = [this.before.value, this.after.value];
    const labels = texts.value;
    if (this.drawn.value === 0 || !first || !second) return [];
    return this.list.value.map((one) => differenceText(one, first, second, labels));
  });
  private readonly stopEffects = [effect(() => this.draw()), effect(() => this.point())];

  constructor(readonly compared: Of) {}

  step(by: number): void {
    const n = this.list.value.length;
    if (n === 0) return;
    const now = this.chosen.peek();
    this.chosen.value = now === null ? (by > 0 ? 0 : n - 1) : (now + by + n) % n;
  }

  /** Reads the blocks' texts again. */
  redraw(): void {
    this.drawn.value += 1;
  }

  dispose(): void {
    for (const stop of this.stopEffects) stop();
  }

  private draw(): void {
    const [before, after] = [this.before.value, this.after.value];
    if (!before || !after) return;
    const { compared } = this;
    fill(before, compared.before.workspace);
    fill(after, compared.after.workspace);
    // the same scale on both sides
    const scale = Math.min(before.fittingScale(), after.fittingScale());
    before.showFromTheStart(scale);
    after.showFromTheStart(scale);
    before.showDifferences(new Map(kindsOf(compared.difference, "before")));
    after.showDifferences(new Map(kindsOf(compared.difference, "after")));
    this.drawn.value = this.drawn.peek() + 1;
  }

  private point(): void {
    const { value: place } = this.chosen;
    const block = place === null ? null : (this.list.value[place]?.block ?? null);
    const [before, after] = [this.before.value, this.after.value];
    before?.point(block);
    after?.point(block);
    if (block && before && after) {
      showNear(before, block, after);
      showNear(after, block, before);
    }
  }
}

/** If only the other side has the block, scrolls to the nearest block above it that both sides have. */
function showNear(side: BlocksViewer, block: string, other: BlocksViewer): void {
  if (side.has(block)) return;
  const near = other.above(block).find((id) => side.has(id));
  if (near) side.reveal(near);
}

function fill(blocks: BlocksViewer, workspace: object): void {
  try {
    blocks.load(workspace);
  } catch {
    blocks.load({});
    problem.value = { message: texts.peek().archive.unreadable, remedy: "" };
  }
}
