import { computed, effect, signal } from "@preact/signals";
import type { VersionOfProgram, VersionSummary } from "../api/model";
import { versionsApi } from "../api/versions";
import { faceOf, type Section, sectionsOf, type VersionStep } from "./line";

/** Delay before a version is loaded, so that fast stepping loads only the last one; and the size of the cache. */
const LOAD_DELAY_MS = 40;
const MAX_CACHED = 40;

/** State of the versions page: the versions of a program and the selected one. */
export class VersionHistory {
  readonly line = signal<VersionSummary[]>([]);
  readonly position = signal(0);
  /** The displayed version; it can lag behind `position` while it loads. */
  readonly shown = signal<VersionOfProgram | null>(null);
  /** Steps that are expanded to single versions, by the id of their first version. */
  readonly unfolded = signal<ReadonlySet<string>>(new Set());
  readonly sections = computed<Section[]>(() => sectionsOf(this.line.value));
  readonly chosen = computed<VersionSummary | null>(
    () => this.line.value[this.position.value] ?? null,
  );
  private readonly stored = new Map<string, Promise<VersionOfProgram>>();
  private readonly stop: () => void;
  private timer = 0;

  constructor(
    line: VersionSummary[],
    versionId: string | null,
    private readonly onError: (error: unknown) => void,
  ) {
    this.line.value = line;
    const place = line.findIndex(({ id }) => id === versionId);
    this.position.value = place < 0 ? Math.max(0, line.length - 1) : place;
    this.stop = effect(() => this.fetch(this.chosen.value?.id));
  }

  get isNewest(): boolean {
    return this.position.value === this.line.value.length - 1;
  }

  /** Number of the parent version, if the parent is not the version directly before; else null. */
  readonly madeOf = computed<number | null>(() => {
    const { value: version } = this.chosen;
    const before = this.line.value[this.position.value - 1];
    if (!version?.parent_id || version.parent_id === before?.id) return null;
    const parent = this.line.value.find(({ id }) => id === version.parent_id);
    return parent && parent.number < version.number - 1 ? parent.number : null;
  });

  /** The parent version; if it is unknown or not in the line, the version before. */
  madeFrom({ id, parent_id }: VersionOfProgram): VersionSummary | null {
    const line = this.line.peek();
    const parent = line.find((one) => one.id === parent_id);
    return parent ?? line[line.findIndex((one) => one.id === id) - 1] ?? null;
  }

  /** The version directly before another in the line, even if it is not the parent. */
  lineBefore({ id }: VersionSummary): VersionSummary | undefined {
    const line = this.line.value;
    return line[line.findIndex((one) => one.id === id) - 1];
  }

  go(place: number): void {
    this.position.value = Math.max(0, Math.min(place, this.line.value.length - 1));
  }

  step(by: number): void {
    this.go(this.position.peek() + by);
  }

  choose(version: VersionSummary): void {
    this.go(this.line.peek().findIndex(({ id }) => id === version.id));
  }

  isUnfolded({ versions: [first] }: VersionStep): boolean {
    return first !== undefined && this.unfolded.value.has(first.id);
  }

  fold({ versions: [first] }: VersionStep): void {
    if (!first) return;
    const unfolded = new Set(this.unfolded.peek());
    if (!unfolded.delete(first.id)) unfolded.add(first.id);
    this.unfolded.value = unfolded;
  }

  holdsChosen(step: VersionStep): boolean {
    const id = this.chosen.value?.id;
    return step.versions.some((one) => one.id === id);
  }

  /** Sets the name of the selected version, on the server and on the page. */
  async name(text: string): Promise<void> {
    const { value: version } = this.chosen;
    if (!version) return;
    await versionsApi.label(version.id, text);
    const label = text.trim();
    this.line.value = this.line.value.map((one) =>
      one.id === version.id ? { ...one, label } : one,
    );
  }

  /** The version to compare with the selected version: the newest, or for the newest the step before it. */
  get counterpart(): VersionSummary | null {
    const line = this.line.value;
    if (!this.isNewest) return line.at(-1) ?? null;
    const steps = this.sections.value.flatMap(({ items }) =>
      items.flatMap((item) => (item.kind === "step" ? [item] : [])),
    );
    const before = steps.at(-2);
    return (before && faceOf(before)) ?? line.at(-2) ?? null;
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.stop();
  }

  private fetch(id: string | undefined): void {
    clearTimeout(this.timer);
    if (!id) return;
    const show = async () => {
      try {
        const version = await this.content(id);
        if (this.chosen.peek()?.id === id) this.shown.value = version;
      } catch (error) {
        this.stored.delete(id);
        this.onError(error);
      }
    };
    this.timer = window.setTimeout(() => void show(), this.shown.peek() ? LOAD_DELAY_MS : 0);
  }

  private content(id: string): Promise<VersionOfProgram> {
    const known = this.stored.get(id) ?? versionsApi.version(id);
    this.stored.set(id, known);
    const [oldest] = this.stored.keys();
    if (this.stored.size > MAX_CACHED && oldest) this.stored.delete(oldest);
    return known;
  }
}
