import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { classesApi } from "../api/classes";
import { exchange, type HeardComputer, type Merged, type Places } from "../api/exchange";
import type { Classroom } from "../api/model";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { Heard } from "./Heard";
import { MergeBox } from "./MergeBox";
import { SaveBox, type Saved } from "./SaveBox";
import { SharedFolder } from "./SharedFolder";
import { words } from "./words";

/** A stick is noticed so soon after it was plugged in. */
const LOOK_MS = 4000;

/** Sticks and the school's folder: bring work in, take work along, and whose work is here. */
export function ExchangePanel() {
  const places = useSignal<Places | null>(null);
  const results = useSignal<Merged[]>([]);
  const saved = useSignal<Saved | null>(null);
  const heard = useSignal<HeardComputer[]>([]);
  const classes = useSignal<Classroom[]>([]);
  const say = words.value;

  const look = async () => {
    places.value = await exchange.folders();
  };
  const all = async () => {
    [places.value, heard.value, classes.value] = await Promise.all([
      exchange.folders(),
      exchange.heard(),
      classesApi.classrooms(),
    ]);
  };
  /** What was answered about one folder is not left standing under another. */
  const forget = () => {
    results.value = [];
    saved.value = null;
  };
  useEffect(() => {
    asTeacher(all).catch(report);
    const timer = setInterval(() => {
      if (!document.hidden) look().catch(() => {}); // said by the first look already
    }, LOOK_MS);
    return () => clearInterval(timer);
  }, []);

  if (!places.value) return <section class="exchange" aria-busy="true" />;
  const { folders, shared } = places.value;
  const lookAtAll = () => void asTeacher(all).catch(report);
  return (
    <section class="exchange" aria-labelledby="exchange-title">
      <h1 id="exchange-title" class="exchange__title">
        {say.title}
      </h1>
      <p class="exchange__intro">{say.intro}</p>
      <MergeBox
        folders={folders}
        results={results}
        onMerged={lookAtAll}
        onLook={() => {
          forget();
          lookAtAll();
        }}
      />
      <SaveBox
        folders={folders}
        classes={classes.value}
        saved={saved}
        onSaved={() => void look().catch(report)}
      />
      <Heard computers={heard.value} />
      <SharedFolder
        path={shared}
        isReachable={!folders.some((one) => one.path === shared && !one.is_reachable)}
        onChoose={forget}
        onChosen={(found) => {
          places.value = found;
        }}
      />
    </section>
  );
}
