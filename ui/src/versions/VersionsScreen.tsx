import { History } from "lucide-preact";
import { useEffect, useLayoutEffect, useState } from "preact/hooks";
import { api } from "../api/client";
import { keeping } from "../api/keeping";
import { couldNotOpen } from "../app/open_program";
import { hashOf } from "../app/route";
import { group, program, report } from "../app/session";
import { texts } from "../i18n";
import { NotOpened } from "../screens/NotOpened";
import { VersionHistory } from "./history";
import { LineList } from "./LineList";
import { LineSlider } from "./LineSlider";
import { VersionPane } from "./VersionPane";

interface VersionsScreenProps {
  programId: string;
  versionId: string | null;
}

/** All versions of a program, to step through and to go on from. */
export function VersionsScreen({ programId, versionId }: VersionsScreenProps) {
  const [history, setHistory] = useState<VersionHistory | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let left = false;
    let made: VersionHistory | null = null;
    load(programId, versionId).then(
      (loaded) => {
        made = loaded;
        if (left) made.dispose();
        else setHistory(made);
      },
      (error) => {
        if (left) return;
        setFailed(true);
        couldNotOpen(error);
      },
    );
    return () => {
      left = true;
      made?.dispose();
    };
  }, [programId]);
  const words = texts.value.keeping;
  if (failed) return <NotOpened />;
  if (!history) {
    return (
      <main class="screen studio studio--opening" aria-busy="true">
        <p>{words.loading}</p>
      </main>
    );
  }
  if (history.line.value.length === 0) return <Empty programId={programId} />;
  return <Versions history={history} />;
}

async function load(programId: string, versionId: string | null): Promise<VersionHistory> {
  const [line, opened] = await Promise.all([keeping.line(programId), api.program(programId)]);
  program.value = opened;
  if (group.value?.id !== opened.group_id) {
    group.value = (await api.groups()).find((one) => one.id === opened.group_id) ?? null;
  }
  return new VersionHistory(line, versionId, report);
}

function Empty({ programId }: { programId: string }) {
  const { keeping: words, header } = texts.value;
  return (
    <main class="screen studio studio--opening">
      <div class="versions__empty">
        <History class="icon" aria-hidden="true" />
        <h1>{words.emptyTitle}</h1>
        <p>{words.empty}</p>
        <a class="button" href={hashOf({ screen: "studio", program: programId })}>
          {header.backToProgram}
        </a>
      </div>
    </main>
  );
}

function Versions({ history }: { history: VersionHistory }) {
  const id = history.chosen.value?.id;
  useLayoutEffect(() => byKeys(history), [history]); // before painting: the first key is heard
  // whoever comes back from comparing finds the version that was looked at
  useEffect(() => {
    const version = history.isNewest ? null : (id ?? null);
    const place = hashOf({ screen: "versions", program: program.peek()?.id ?? "", version });
    window.history.replaceState(null, "", place);
  }, [id]);
  return (
    <main class="screen versions">
      <h1 class="visually-hidden">{texts.value.keeping.historyOf(program.value?.name ?? "")}</h1>
      <VersionPane history={history} />
      <LineList history={history} />
      <LineSlider history={history} />
    </main>
  );
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowLeft: -1,
  ArrowRight: 1,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

/** The arrows step through the versions, wherever the keyboard is not at something that needs them. */
function byKeys(history: VersionHistory): () => void {
  const onKey = (event: KeyboardEvent) => {
    const by = STEPS[event.key];
    const at = event.target as Element;
    if (by === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    if (at.closest?.("input, select, textarea, .injectionDiv")) return;
    history.step(by);
    event.preventDefault();
  };
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}
