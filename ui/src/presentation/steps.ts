import { inOrder, type Playback, type Stretch, stepFrom } from "../run/playback";

/** Steps through a replay block by block, of one run or of two on one clock. */
export class Steps {
  private readonly blocks: readonly Stretch[];

  constructor(
    private readonly playback: Playback,
    tracks: readonly (readonly Stretch[])[],
    private readonly isStill: () => boolean,
  ) {
    this.blocks = inOrder(tracks);
  }

  /** Plays until the next block begins; during that, goes there at once. */
  next(): void {
    const { playback } = this;
    const goal = playback.goal.peek() ?? this.from(1);
    if (playback.goal.peek() !== null || this.isStill()) this.jump(goal);
    else if (goal > playback.tick.peek()) playback.playTo(goal);
  }

  /** Goes back to where the current block began, or the one before it. */
  previous(): void {
    this.jump(this.from(-1));
  }

  private from(direction: -1 | 1): number {
    return stepFrom(this.blocks, this.playback.tick.peek(), direction, this.playback.end);
  }

  private jump(tick: number): void {
    this.playback.pause();
    this.playback.seek(tick);
  }
}
