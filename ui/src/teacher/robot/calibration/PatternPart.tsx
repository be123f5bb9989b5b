import { Blocks, Check } from "lucide-preact";
import type { RealRun } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { decimal } from "../../../i18n/format";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { useAction } from "../../../kit/requests/action";
import { FaultLine } from "../../../kit/requests/FaultLine";
import { Loaded } from "../../../kit/requests/Loaded";
import { useLoaded } from "../../../kit/requests/useLoaded";
import { realRobots } from "../../../run/real/real_robot";
import { hashOf } from "../../../shell/route";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { driven, NEEDED, SHAPES, type Shape, sideFor } from "./pattern";
import { findPrograms, makePrograms, type Names } from "./pattern_programs";

/** Offers the programs with which a robot is calibrated, and shows which of their runs are there. */
export function PatternPart({ runs }: { runs: readonly RealRun[] }) {
  const { pattern: labels } = texts.value.calibration;
  const robots = realRobots.value.filter(({ is_set_up }) => is_set_up);
  const side = sideFor(robots);
  const isPossible = robots.length > 0 && side !== null;
  return (
    <section class="calibration__pattern" data-testid="pattern">
      <h3>{labels.title}</h3>
      <p class="teacher__hint">{labels.hint}</p>
      {isPossible ? (
        <Programs key={`${side} ${language.value}`} side={side} runs={runs} />
      ) : (
        <p class="notice-box">{robots.length === 0 ? labels.noRobot : labels.small}</p>
      )}
    </section>
  );
}

function Programs({ side, runs }: { side: number; runs: readonly RealRun[] }) {
  const { pattern: labels } = texts.value.calibration;
  const m = decimal(side, 1, language.value);
  const names: Names = {
    line: labels.line({ m }),
    left: labels.left({ m }),
    right: labels.right({ m }),
  };
  const found = useLoaded(m, () => findPrograms(names));
  const { busy, fault, act } = useAction(asTeacher);
  return (
    <Loaded of={found}>
      {(programs) => (
        <>
          <ul class="calibration__parts">
            {SHAPES.map((shape) => (
              <Part
                key={shape}
                shape={shape}
                name={names[shape]}
                program={programs[shape]}
                runs={runs}
              />
            ))}
          </ul>
          {SHAPES.some((shape) => !programs[shape]) && (
            <Button
              icon={Blocks}
              busy={busy}
              testId="pattern-make"
              onPress={() =>
                act(async () => {
                  await makePrograms(names, side, programs);
                  await found.reload();
                })
              }
            >
              {labels.make}
            </Button>
          )}
          <FaultLine fault={fault} />
        </>
      )}
    </Loaded>
  );
}

interface PartProps {
  shape: Shape;
  name: string;
  program: string | undefined;
  runs: readonly RealRun[];
}

function Part({ shape, name, program, runs }: PartProps) {
  const { pattern: labels } = texts.value.calibration;
  const { measured: n, unmeasured } = driven(runs, shape);
  const isEnough = n >= NEEDED[shape];
  return (
    <li
      class="calibration__run row middle gap-2"
      data-testid="pattern-part"
      data-shape={shape}
      data-measured={n}
    >
      <strong class="calibration__part">{name}</strong>
      <span class={isEnough ? "calibration__measured row middle gap-1" : "aside"}>
        {isEnough && <Check class="icon" aria-hidden="true" />}
        {isEnough ? labels.enough({ n }) : labels.count({ n, needed: NEEDED[shape] })}
        {unmeasured > 0 && ` · ${labels.unmeasured({ n: unmeasured })}`}
      </span>
      {program && (
        <LinkButton
          icon={Blocks}
          href={hashOf({ screen: "studio", program })}
          testId="pattern-open"
        >
          {labels.open}
        </LinkButton>
      )}
    </li>
  );
}
