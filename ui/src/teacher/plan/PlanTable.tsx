import { CircleCheck, Play } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { hashOf, type Route } from "../../shell/route";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { openForClass, type PlanClass } from "./open_for_class";

type Step = keyof typeof texts.value.plan.steps;
type Link = keyof typeof texts.value.plan.links;

/** The steps in order, with the activity or the link of each. */
const STEPS: Readonly<Record<Step, { activity?: string; link?: Link }>> = {
  human: {},
  alphabet: { link: "letters" },
  first: { activity: "around_the_corner" },
  paper: { link: "cards" },
  blocks: { activity: "letter" },
  decide: { activity: "sign_b" },
  show: {},
  talk: { link: "lessons" },
};

const ROUTES: Readonly<Record<Link, Route>> = {
  letters: { screen: "practice" },
  cards: { screen: "cards" },
  lessons: { screen: "teacher", part: "lessons" },
};

interface PlanTableProps {
  /** Id of the class; null if there are no classes. */
  classroom: string | null;
  found: PlanClass;
  reload(): Promise<void>;
}

/** The steps of the lesson: time, actions of the teacher and of the groups, content of the screen. */
export function PlanTable({ classroom, found, reload }: PlanTableProps) {
  const { plan: labels } = texts.value;
  const { fault, act } = useAction(asTeacher);
  const open = (activity: string) =>
    act(async () => {
      if (classroom) await openForClass(classroom, found.current, labels.title, activity);
      await reload();
    });
  return (
    <>
      <table class="plan__steps">
        <thead>
          <tr>
            {Object.entries(labels.columns).map(([name, title]) => (
              <th key={name} scope="col" class={`plan__${name}`}>
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {(Object.keys(STEPS) as Step[]).map((step) => {
            const { minutes, teacher, groups, screen } = labels.steps[step];
            const { activity, link } = STEPS[step];
            return (
              <tr key={step} data-testid="plan-step" data-name={step}>
                <th scope="row">{minutes}</th>
                <td>{teacher}</td>
                <td>{groups}</td>
                <td>
                  {screen}
                  {link && (
                    <LinkButton href={hashOf(ROUTES[link])}>{labels.links[link]}</LinkButton>
                  )}
                  {activity && classroom && (
                    <OpenActivity name={activity} found={found} onOpen={() => open(activity)} />
                  )}
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <FaultLine fault={fault} />
    </>
  );
}

interface OpenActivityProps {
  name: string;
  found: PlanClass;
  onOpen(): Promise<boolean>;
}

/** Button that sets the activity of the class's open lesson, or shows that it is already set. */
function OpenActivity({ name, found: { current, activities }, onOpen }: OpenActivityProps) {
  const { plan: labels } = texts.value;
  const known = activities.find((one) => one.name === name);
  const title = known ? `${known.number} ${known.title}` : name;
  const isOpen = current?.activity === name;
  return (
    <>
      <Button
        icon={isOpen ? CircleCheck : Play}
        pressed={isOpen}
        testId="plan-open"
        data-name={name}
        onPress={() => !isOpen && onOpen()}
      >
        {labels.open({ activity: title })}
      </Button>
      <span class="visually-hidden" role="status">
        {isOpen && labels.isOpen({ activity: title })}
      </span>
    </>
  );
}
