import { useEffect, useState } from "preact/hooks";
import { api } from "../api/client";
import {
  keeping,
  type StoredVersion,
  type VersionDifference,
  type VersionMark,
} from "../api/keeping";
import { couldNotOpen } from "../app/open_program";
import { group, program } from "../app/session";
import { texts } from "../i18n";
import { NotOpened } from "../screens/NotOpened";
import { Differences } from "./Differences";

interface DifferencesScreenProps {
  program: string;
  before: string;
  after: string;
}

/** Two versions and what differs between them. */
export interface Compared {
  line: readonly VersionMark[];
  before: StoredVersion;
  after: StoredVersion;
  difference: VersionDifference;
}

/** Two versions of a program side by side, and what became of each block. */
export function DifferencesScreen({ program: programId, before, after }: DifferencesScreenProps) {
  const [compared, setCompared] = useState<Compared | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let left = false;
    load(programId, before, after).then(
      (loaded) => {
        if (!left) setCompared(loaded);
      },
      (error) => {
        if (left) return;
        setFailed(true);
        couldNotOpen(error);
      },
    );
    return () => {
      left = true;
    };
  }, []);
  if (failed) return <NotOpened />;
  if (!compared) {
    return (
      <main class="screen studio studio--opening" aria-busy="true">
        <p>{texts.value.keeping.loading}</p>
      </main>
    );
  }
  return <Differences compared={compared} programId={programId} />;
}

async function load(programId: string, before: string, after: string): Promise<Compared> {
  const [line, first, second, difference, opened] = await Promise.all([
    keeping.line(programId),
    keeping.version(before),
    keeping.version(after),
    keeping.difference(before, after),
    api.program(programId),
  ]);
  program.value = opened;
  if (group.value?.id !== opened.group_id) {
    group.value = (await api.groups()).find((one) => one.id === opened.group_id) ?? null;
  }
  return { line, before: first, after: second, difference };
}
