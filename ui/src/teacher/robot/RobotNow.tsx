import { Flag, MapPin } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import type { RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { FaultLine } from "../../kit/requests/FaultLine";
import { RobotState } from "../../run/real/RobotState";
import {
  poseInRoom,
  robotStates,
  type RobotState as State,
  useWatchedRobot,
} from "../../run/real/robot_state";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { JogPad } from "./JogPad";
import { RoomPicture } from "./RoomPicture";
import { type Draft, startAt } from "./robot_description";

interface RobotNowProps {
  robot: RealRobot;
  draft: Draft;
  fill(texts: Draft): void;
}

/** Current state and pose of a real robot. Has buttons that jog it, and one that uses its pose as the start. */
export function RobotNow({ robot, draft, fill }: RobotNowProps) {
  const { now: labels } = texts.value.robotSetup;
  const { link } = robot;
  useWatchedRobot(link);
  const [isUsed, setUsed] = useState(false);
  useEffect(() => setUsed(false), [robot]); // the form was saved
  const state = robotStates.value[link];
  const place = state && poseInRoom(state);
  const use = () => {
    if (!place) return;
    fill(startAt(place, language.value));
    setUsed(true);
  };
  const setStartHere = () => asTeacher(() => robotsApi.setStartHere(link));
  return (
    <section class="robot-now" aria-label={labels.title}>
      <h2>{labels.title}</h2>
      <p class="robot-now__state">
        <RobotState link={link} testId="robot-now" />
        {state && more(state)}
      </p>
      <FaultLine fault={state?.code ? state : null} />
      <div class="robot-now__drive">
        <JogPad link={link} />
        <RoomPicture draft={draft} link={link} />
      </div>
      <div class="teacher__row">
        <Button icon={MapPin} disabled={!place} testId="robot-here" onPress={use}>
          {labels.use}
        </Button>
        <Button icon={Flag} disabled={!place} testId="robot-at-start" onPress={setStartHere}>
          {labels.atStart}
        </Button>
      </div>
      <p role="status" class="teacher__done">
        {isUsed && labels.used}
      </p>
      <p class="teacher__hint">{labels.honest}</p>
    </section>
  );
}

function more(state: State): string {
  const { now: labels } = texts.value.robotSetup;
  const number = (value: number, digits: number) => decimal(value, digits, language.value);
  const place = poseInRoom(state);
  return [
    state.rate_hz !== null && labels.rate({ times: number(state.rate_hz, 0) }),
    place &&
      labels.place({
        x: number(place.x_m, 2),
        y: number(place.y_m, 2),
        heading: number(place.heading_deg, 0),
      }),
  ]
    .filter(Boolean)
    .map((text) => ` · ${text}`)
    .join("");
}
