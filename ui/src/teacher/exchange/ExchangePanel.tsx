import { useSignal } from "@preact/signals";
import { classesApi } from "../../api/classes";
import { exchange } from "../../api/exchange";
import type { FolderList } from "../../api/model";
import { texts } from "../../i18n";
import { Loaded } from "../../kit/requests/Loaded";
import type { Loadable } from "../../kit/requests/useLoaded";
import { usePolling } from "../../kit/usePolling";
import { useTeacherLoaded } from "../useTeacherLoaded";
import { KnownComputers } from "./KnownComputers";
import { MergeBox } from "./MergeBox";
import { SaveBox, type Saved } from "./SaveBox";
import { SharedFolder } from "./SharedFolder";
import { useMerging } from "./useMerging";

/** Polling interval for sticks. */
const POLL_MS = 4000;

/** Merges from and exports to sticks and the shared folder; lists the PCs whose work this PC has. */
export function ExchangePanel() {
  const places = useTeacherLoaded("places", () => exchange.folders());
  const known = useTeacherLoaded("known", loadKnown);
  return (
    <section class="exchange grid gap-4" aria-labelledby="exchange-title">
      <h1 id="exchange-title">{texts.value.exchange.title}</h1>
      <p class="teacher__hint">{texts.value.exchange.intro}</p>
      <Loaded of={places}>
        {(found) => <Boxes found={found} places={places} known={known} />}
      </Loaded>
    </section>
  );
}

type Known = Awaited<ReturnType<typeof loadKnown>>;

/** Loads the PCs whose work this PC has, and the classes. */
async function loadKnown() {
  const [knownComputers, classes] = await Promise.all([
    exchange.knownComputers(),
    classesApi.classrooms(),
  ]);
  return { knownComputers, classes };
}

interface BoxesProps {
  found: FolderList;
  places: Loadable<FolderList>;
  known: Loadable<Known>;
}

function Boxes({ found, places, known }: BoxesProps) {
  const { folders, shared, takes_backups } = found;
  const saved = useSignal<Saved | null>(null);
  // shows a newly plugged-in stick; ignores failures, because the first request reports them
  usePolling(() => exchange.folders().then(places.set, () => {}), { everyMs: POLL_MS });
  const loadAll = async () => {
    await Promise.all([places.reload(), known.reload()]);
  };
  const merging = useMerging(loadAll);
  /** Clears the results, which must not appear under another folder. */
  const forgetAnswers = () => {
    merging.forget();
    saved.value = null;
  };
  const reload = () => {
    forgetAnswers();
    return loadAll();
  };
  const waiting = known.status === "ready" ? known.value.knownComputers.undecided : [];
  const undecided = waiting.filter(({ path }) => !merging.isAsked(path));
  return (
    <>
      <MergeBox found={found} merging={merging} undecided={undecided} onReload={reload} />
      <Loaded of={known}>
        {({ knownComputers, classes }) => (
          <>
            <SaveBox folders={folders} classes={classes} saved={saved} onSaved={places.reload} />
            <KnownComputers knownComputers={knownComputers} onAgain={known.reload} />
          </>
        )}
      </Loaded>
      <SharedFolder
        path={shared}
        storesBackups={takes_backups}
        isReachable={!folders.some((one) => one.path === shared && !one.is_reachable)}
        onChoose={forgetAnswers}
        onChosen={places.set}
      />
    </>
  );
}
