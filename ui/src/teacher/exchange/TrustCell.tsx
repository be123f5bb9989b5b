import { ShieldAlert, ShieldCheck, ShieldQuestion } from "lucide-preact";
import { exchange } from "../../api/exchange";
import type { KnownComputer, KnownComputerList } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

const ICONS = {
  own: ShieldCheck,
  approved: ShieldCheck,
  unapproved: ShieldQuestion,
  changed_key: ShieldAlert,
  unsigned: ShieldQuestion,
} as const;

interface TrustCellProps {
  computer: KnownComputer;
  onApproved(known: KnownComputerList): void;
}

/** Whether the teacher approved a PC, its code to compare, and the button to approve it or to undo that. */
export function TrustCell({ computer, onApproved }: TrustCellProps) {
  const { busy, fault, act } = useAct(asTeacher);
  const { trust: say } = texts.value.exchange;
  const { trust, public_key: key, fingerprint } = computer;
  const Icon = ICONS[trust];
  const isApproved = trust === "approved";
  const change = (public_key: string) =>
    act(async () => onApproved(await exchange.approve(public_key, !isApproved)));
  return (
    <div class="trust" data-testid="computer-trust" data-trust={trust}>
      <span class="trust__state">
        <Icon class="icon" aria-hidden="true" />
        {say.states[trust]}
      </span>
      {fingerprint && <code class="trust__code">{fingerprint}</code>}
      {key && trust !== "own" && (
        <Button
          kind={isApproved ? "plain" : undefined}
          busy={busy}
          testId="approve-computer"
          label={(isApproved ? say.withdrawOf : say.approveOf)(computer.name)}
          onPress={() => change(key)}
        >
          {isApproved ? say.withdraw : say.approve}
        </Button>
      )}
      <FaultLine fault={fault} />
    </div>
  );
}
