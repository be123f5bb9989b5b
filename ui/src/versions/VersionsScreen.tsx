import { History } from "lucide-preact";
import { useEffect, useLayoutEffect } from "preact/hooks";
import { versionsApi } from "../api/versions";
import { texts } from "../i18n";
import { LinkButton } from "../kit/LinkButton";
import { listenForKeys } from "../kit/listen";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { nameInHeader } from "../shell/named";
import { hashOf, type ParametersOf } from "../shell/route";
import { program, report } from "../shell/session";
import { couldNotOpen } from "../studio/program/open_program";
import { VersionHistory } from "./history";
import { VersionList } from "./VersionList";
import { VersionPane } from "./VersionPane";
import { VersionSlider } from "./VersionSlider";

/** All versions of a program, with stepping and a way to continue from any of them. */
export function VersionsScreen({
  program: programId,
  version: versionId,
}: ParametersOf<"versions">) {
  const history = useLoaded(programId, () => load(programId, versionId), {
    onFailed: couldNotOpen,
    release: (made) => made.dispose(),
  });
  return (
    <Loaded of={history} as="screen" loading={texts.value.archive.loading}>
      {(loaded) =>
        loaded.line.value.length === 0 ? (
          <Empty programId={programId} />
        ) : (
          <Versions history={loaded} />
        )
      }
    </Loaded>
  );
}

async function load(programId: string, versionId: string | null): Promise<VersionHistory> {
  const [line] = await Promise.all([versionsApi.line(programId), nameInHeader(programId)]);
  return new VersionHistory(line, versionId, report);
}

function Empty({ programId }: { programId: string }) {
  const { archive: labels, header } = texts.value;
  return (
    <main class="screen waiting">
      <div class="versions__empty">
        <History class="icon" aria-hidden="true" />
        <h1>{labels.emptyTitle}</h1>
        <p>{labels.empty}</p>
        <LinkButton href={hashOf({ screen: "studio", program: programId })}>
          {header.backToProgram}
        </LinkButton>
      </div>
    </main>
  );
}

function Versions({ history }: { history: VersionHistory }) {
  const id = history.chosen.value?.id;
  useLayoutEffect(() => byKeys(history), [history]); // before painting, so that no key press is missed
  // returning from a comparison selects the version that was shown before
  useEffect(() => {
    const version = history.isNewest ? null : (id ?? null);
    const place = hashOf({ screen: "versions", program: program.peek()?.id ?? "", version });
    window.history.replaceState(null, "", place);
  }, [id]);
  return (
    <main class="screen versions">
      <h1 class="visually-hidden">
        {texts.value.archive.historyOf({ program: program.value?.name ?? "" })}
      </h1>
      <VersionPane history={history} />
      <VersionList history={history} />
      <VersionSlider history={history} />
    </main>
  );
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowLeft: -1,
  ArrowRight: 1,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
};

/** The arrow keys step through the versions, unless the focused element uses these keys. */
function byKeys(history: VersionHistory): () => void {
  return listenForKeys((key) => {
    const by = STEPS[key];
    if (by !== undefined) history.step(by);
    return by !== undefined;
  });
}
