import type { VersionSummary } from "../api/model";

/** The versions of one entry: a burst of edits, or one notable version. The last version represents the step. */
export interface VersionStep {
  readonly kind: "step";
  readonly versions: readonly VersionSummary[];
}

/** Parallel branches: versions that several PCs made from one version, without knowing of each other. */
export interface Fork {
  readonly kind: "fork";
  readonly branches: readonly Branch[];
}

export interface Branch {
  readonly computer: string | null;
  readonly steps: readonly VersionStep[];
}

/** The versions of one day in one lesson. */
export interface Section {
  readonly from: string;
  readonly to: string;
  readonly items: readonly (VersionStep | Fork)[];
}

/** Pause that ends a burst of edits. */
const PAUSE_MS = 90_000;

/** Groups the versions of a program, oldest first, into sections. */
export function sectionsOf(line: readonly VersionSummary[]): Section[] {
  const sections: Section[] = [];
  for (const stretch of stretches(line)) {
    for (const part of stretch.forked ? [stretch.versions] : byLesson(stretch.versions)) {
      const items = stretch.forked ? [forkOf(part)] : foldedInto(part);
      const last = sections.at(-1);
      const [first, end] = [part[0], part.at(-1)];
      if (!first || !end) continue;
      if (last && follows(lastOf(last), first)) {
        sections[sections.length - 1] = joined(last, items, end);
      } else sections.push({ from: first.created_at, to: end.created_at, items });
    }
  }
  return sections;
}

/** The version that represents a step: its last. */
export function faceOf({ versions }: VersionStep): VersionSummary {
  return versions[versions.length - 1] as VersionSummary;
}

/** All versions of a section, in the order of the line. */
export function versionsIn({ items }: Section): VersionSummary[] {
  return items.flatMap((item) =>
    item.kind === "step"
      ? item.versions
      : item.branches.flatMap(({ steps }) => steps.flatMap(({ versions }) => versions)),
  );
}

function joined(
  section: Section,
  items: readonly (VersionStep | Fork)[],
  end: VersionSummary,
): Section {
  return { ...section, to: end.created_at, items: [...section.items, ...items] };
}

function lastOf(section: Section): VersionSummary {
  return versionsIn(section).at(-1) as VersionSummary;
}

interface Stretch {
  forked: boolean;
  versions: VersionSummary[];
}

/** Splits the line into parts with unique version numbers and parts with repeated numbers. */
function stretches(line: readonly VersionSummary[]): Stretch[] {
  const count = new Map<number, number>();
  for (const { number } of line) count.set(number, (count.get(number) ?? 0) + 1);
  const found: Stretch[] = [];
  for (const version of line) {
    const forked = (count.get(version.number) ?? 0) > 1;
    const last = found.at(-1);
    if (last?.forked === forked) last.versions.push(version);
    else found.push({ forked, versions: [version] });
  }
  return found;
}

function forkOf(versions: readonly VersionSummary[]): Fork {
  const computers = new Set(versions.map(({ computer }) => computer));
  const branches = computers.size > 1 ? byComputer(versions) : byParent(versions);
  return {
    kind: "fork",
    branches: branches.map((branch) => ({
      computer: branch[0]?.computer ?? null,
      steps: foldedInto(branch),
    })),
  };
}

function byComputer(versions: readonly VersionSummary[]): VersionSummary[][] {
  const branches = new Map<string | null, VersionSummary[]>();
  for (const version of versions) {
    const branch = branches.get(version.computer);
    if (branch) branch.push(version);
    else branches.set(version.computer, [version]);
  }
  return [...branches.values()];
}

/** Splits by parent version, for PCs without names or with the same name. */
function byParent(versions: readonly VersionSummary[]): VersionSummary[][] {
  const branches: VersionSummary[][] = [];
  const home = new Map<string, VersionSummary[]>();
  for (const version of versions) {
    let branch = version.parent_id === null ? undefined : home.get(version.parent_id);
    if (!branch || branch.at(-1)?.number === version.number) {
      branch = [];
      branches.push(branch);
    }
    branch.push(version);
    home.set(version.id, branch);
  }
  return branches;
}

function byLesson(versions: readonly VersionSummary[]): VersionSummary[][] {
  return split(versions, follows);
}

function follows(before: VersionSummary, version: VersionSummary): boolean {
  return before.lesson_id === version.lesson_id && day(before) === day(version);
}

function day({ created_at }: VersionSummary): string {
  return new Date(created_at).toDateString();
}

function foldedInto(versions: readonly VersionSummary[]): VersionStep[] {
  return split(versions, isOneBurst).map((burst) => ({ kind: "step", versions: burst }));
}

function isOneBurst(before: VersionSummary, version: VersionSummary): boolean {
  const gapMs = Math.abs(Date.parse(version.created_at) - Date.parse(before.created_at));
  return isPlain(before) && isPlain(version) && gapMs < PAUSE_MS;
}

function isPlain({ label, n_runs }: VersionSummary): boolean {
  return !label && n_runs === 0;
}

function split(
  versions: readonly VersionSummary[],
  belong: (before: VersionSummary, version: VersionSummary) => boolean,
): VersionSummary[][] {
  const parts: VersionSummary[][] = [];
  let before: VersionSummary | undefined;
  for (const version of versions) {
    if (before && belong(before, version)) parts.at(-1)?.push(version);
    else parts.push([version]);
    before = version;
  }
  return parts;
}
