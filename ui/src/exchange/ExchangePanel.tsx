import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { classesApi } from "../api/classes";
import { exchange, type Folder, type HeardComputer } from "../api/exchange";
import type { Classroom } from "../api/model";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { Heard } from "./Heard";
import { MergeBox } from "./MergeBox";
import { SaveBox } from "./SaveBox";
import { SharedFolder } from "./SharedFolder";
import { words } from "./words";

/** A stick is noticed so soon after it was plugged in. */
const LOOK_MS = 4000;

/** Sticks and the school's folder: bring work in, take work along, and whose work is here. */
export function ExchangePanel() {
  const folders = useSignal<Folder[] | null>(null);
  const heard = useSignal<HeardComputer[]>([]);
  const classes = useSignal<Classroom[]>([]);
  const say = words.value;

  const look = async () => {
    folders.value = await exchange.folders();
  };
  const all = async () => {
    [folders.value, heard.value, classes.value] = await Promise.all([
      exchange.folders(),
      exchange.heard(),
      classesApi.classrooms(),
    ]);
  };
  useEffect(() => {
    asTeacher(all).catch(report);
    const timer = setInterval(() => {
      if (!document.hidden) look().catch(() => {}); // said by the first look already
    }, LOOK_MS);
    return () => clearInterval(timer);
  }, []);

  if (!folders.value) return <section class="exchange" aria-busy="true" />;
  return (
    <section class="exchange" aria-labelledby="exchange-title">
      <h1 id="exchange-title" class="exchange__title">
        {say.title}
      </h1>
      <p class="exchange__intro">{say.intro}</p>
      <MergeBox folders={folders.value} onLook={() => void asTeacher(all).catch(report)} />
      <SaveBox
        folders={folders.value}
        classes={classes.value}
        onSaved={() => void look().catch(report)}
      />
      <Heard computers={heard.value} />
      <SharedFolder
        path={folders.value.find((one) => !one.is_stick)?.path ?? ""}
        onChosen={(found) => {
          folders.value = found;
        }}
      />
    </section>
  );
}
