import { ArrowRight, PartyPopper, Target, Volume2, VolumeX } from "lucide-preact";
import { NewStickers } from "../../album/NewStickers";
import type { Activity } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { isSoundTurnedOn, muted, playSound, setMuted } from "../../run/sounds/sound";
import { beginActivity } from "../../shell/begin_activity";
import { hashOf } from "../../shell/route";
import { group } from "../../shell/session";
import type { OpenProgram } from "../program/open_program";

interface SuccessProps {
  open: OpenProgram;
  mission: Activity;
  /** The run that has just passed; null if an earlier one has. */
  run: string | null;
}

/** A passed mission: the result, a question to discuss, and the next steps. */
export function Success({ open, mission, run }: SuccessProps) {
  const { activity } = texts.value;
  const { next } = mission;
  return (
    <div class="mission__success" role="status" data-testid="mission-done">
      <strong>
        <PartyPopper class="icon" aria-hidden="true" />
        {activity.done}
      </strong>
      {mission.question && <p>{mission.question}</p>}
      <div class="row wrap gap-2">
        {next ? (
          <Button
            kind="main"
            iconEnd={ArrowRight}
            testId="mission-next"
            onPress={() => beginActivity(open.program.group_id, next.name)}
          >
            {activity.next({ title: next.title })}
          </Button>
        ) : (
          <LinkButton
            icon={Target}
            testId="mission-others"
            href={hashOf({ screen: "activities", group: open.program.group_id })}
          >
            {activity.others}
          </LinkButton>
        )}
        <Sound />
        {run && group.value?.has_album && <NewStickers group={open.program.group_id} run={run} />}
      </div>
    </div>
  );
}

/** Turns sound on or off: the fanfare only plays if somebody has turned sound on. */
function Sound() {
  const { show } = texts.value;
  const isOn = isSoundTurnedOn.value;
  return (
    <Button
      kind="plain"
      icon={isOn ? Volume2 : VolumeX}
      label={isOn ? show.mute : show.unmute}
      testId="success-sound"
      onPress={() => {
        setMuted(isOn);
        if (!muted.value) playSound("success");
      }}
    />
  );
}
