import { computed, signal } from "@preact/signals";

/** Words of one round. */
export const N_TARGETS = 5;

/** What a round showed: nothing is counted against a group, and nothing is timed. */
export interface RoundOutcome {
  readonly spelled: readonly string[];
  /** Letters that the group made without the hint, each once, in the order of the alphabet. */
  readonly alone: readonly string[];
  /** Letters for which the group asked for the hint. */
  readonly hinted: readonly string[];
}

/** A round of words that are spelled letter by letter. */
export class SpellingGame {
  private readonly at = signal(0);
  /** Number of letters of the word that are spelled. */
  readonly nSpelled = signal(0);
  /** Whether the hand of the next letter is shown. */
  readonly isHinted = signal(false);
  /** The last sign if it was not the next letter, else null. */
  readonly other = signal<string | null>(null);
  /** The word to spell; null after the round. */
  readonly current = computed(() => this.targets[this.at.value] ?? null);
  readonly next = computed(() => this.current.value?.[this.nSpelled.value] ?? null);
  private readonly spelled: string[] = [];
  private readonly alone = new Set<string>();
  private readonly hinted = new Set<string>();

  constructor(readonly targets: readonly string[]) {}

  /** Number of the word in its round, from 1. */
  get number(): number {
    return this.at.value + 1;
  }

  /** A sign was shown, or its key was pressed: the next letter advances the word. */
  receive(sign: string): void {
    const { value: letter } = this.next;
    if (letter === null) return;
    this.other.value = sign === letter ? null : sign;
    if (sign !== letter) return;
    (this.isHinted.value ? this.hinted : this.alone).add(letter);
    this.isHinted.value = false;
    this.nSpelled.value += 1;
    if (this.next.value === null) this.endTarget(true);
  }

  hint(): void {
    this.isHinted.value = true;
  }

  skip(): void {
    this.endTarget(false);
  }

  get outcome(): RoundOutcome {
    const hinted = [...this.hinted].sort();
    const alone = [...this.alone].filter((letter) => !this.hinted.has(letter)).sort();
    return { spelled: this.spelled, alone, hinted };
  }

  private endTarget(isSpelled: boolean): void {
    if (isSpelled && this.current.value) this.spelled.push(this.current.value);
    this.nSpelled.value = 0;
    this.isHinted.value = false;
    this.other.value = null;
    this.at.value += 1;
  }
}

/** Words for a round, in any order. */
export function drawTargets(all: readonly string[], random: () => number = Math.random): string[] {
  const left = [...all];
  const drawn: string[] = [];
  while (drawn.length < N_TARGETS && left.length > 0) {
    drawn.push(...left.splice(Math.floor(random() * left.length), 1));
  }
  return drawn;
}
