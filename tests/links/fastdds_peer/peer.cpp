// A robot of ROS 2 on eProsima's Fast DDS: follows Twist or TwistStamped as a unicycle and publishes Odometry, 100 times a second.
//
//   peer DOMAIN COMMAND_TOPIC ODOMETRY_TOPIC twist|twist_stamped [COMMAND_USER_DATA ODOMETRY_USER_DATA]
//
// It speaks over UDP on this PC only. On standard output, a JSON object on each line:
//   {"ready": true}                                              commands are listened to
//   {"writer": TOPIC, "type": ..., "user_data": ..., "reliable": ...}   somebody who publishes commands was discovered
//   {"reader": TOPIC, "type": ..., "user_data": ..., "reliable": ...}   somebody who subscribes to odometry was discovered
//   {"at": ..., "v": ..., "omega": ..., "frame": ..., "stamp": ...}     a command; `at` in s of CLOCK_MONOTONIC
// On standard input, a word on each line: `mute` and `speak` stop and resume the odometry. The end of input ends the peer.

#include "messages.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastrtps/utils/IPLocator.h>

#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

static const double PERIOD_S = 0.01;
static const double WATCHDOG_S = 0.6;  // as RosAria's: a robot that hears nothing stops by itself
static const int PARTICIPANTS = 20;    // discovery ports of this PC that are tried; many tests may run at once

static double seconds(clockid_t clock)
{
    timespec now;
    clock_gettime(clock, &now);
    return double(now.tv_sec) + now.tv_nsec * 1e-9;
}

static void say(const std::string& line)
{
    static std::mutex lock;
    std::lock_guard<std::mutex> held(lock);
    std::puts(line.c_str());
    std::fflush(stdout);
}

static std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (char c : text)
    {
        out += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 32 ? '?' : c;
    }
    return out + "\"";
}

// JSON knows neither NaN nor infinity.
static std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return std::isfinite(value) ? text : std::string("\"") + text + "\"";
}

class Robot
{
public:
    void hear(const Twist& twist, const Header& header)
    {
        const double at = seconds(CLOCK_MONOTONIC);
        {
            std::lock_guard<std::mutex> held(lock_);
            twist_ = twist;
            heard_s_ = at;
        }
        say("{\"at\": " + number(at) + ", \"v\": " + number(twist.linear[0]) + ", \"omega\": " +
            number(twist.angular[2]) + ", \"frame\": " + quoted(header.frame_id) + ", \"stamp\": " +
            number(header.sec + header.nanosec * 1e-9) + "}");
    }

    // Drives on to now, and tells where it is.
    Odometry report()
    {
        std::lock_guard<std::mutex> held(lock_);
        const double now = seconds(CLOCK_MONOTONIC);
        if (now - heard_s_ > WATCHDOG_S)
        {
            twist_ = Twist();
        }
        const double v = twist_.linear[0], omega = twist_.angular[2], dt = now - at_s_;
        at_s_ = now;
        if (std::isfinite(v) && std::isfinite(omega))
        {
            x_ += v * dt * std::cos(yaw_ + omega * dt / 2);
            y_ += v * dt * std::sin(yaw_ + omega * dt / 2);
            yaw_ += omega * dt;
        }
        timespec stamp;
        clock_gettime(CLOCK_REALTIME, &stamp);
        Odometry odometry;
        odometry.header = {int32_t(stamp.tv_sec), uint32_t(stamp.tv_nsec), "odom"};
        odometry.child_frame_id = "base_link";
        odometry.position = {{x_, y_, 0.0}};
        odometry.orientation = {{0.0, 0.0, std::sin(yaw_ / 2), std::cos(yaw_ / 2)}};
        odometry.twist = twist_;
        return odometry;
    }

private:
    std::mutex lock_;
    Twist twist_;
    double x_ = 0.0, y_ = 0.0, yaw_ = 0.0;
    double heard_s_ = 0.0, at_s_ = seconds(CLOCK_MONOTONIC);
};

static const Twist& twist_of(const Twist& message) { return message; }
static const Twist& twist_of(const TwistStamped& message) { return message.twist; }
static Header header_of(const Twist&) { return Header(); }
static Header header_of(const TwistStamped& message) { return message.header; }

template <typename Message>
class Commands : public fast::DataReaderListener
{
public:
    explicit Commands(Robot& robot) : robot_(robot) {}

    void on_data_available(fast::DataReader* reader) override
    {
        Message message;
        fast::SampleInfo info;
        while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK)
        {
            if (info.valid_data)
            {
                robot_.hear(twist_of(message), header_of(message));
            }
        }
    }

private:
    using ReturnCode_t = eprosima::fastrtps::types::ReturnCode_t;
    Robot& robot_;
};

// Tells who else is in the domain.
class Others : public fast::DomainParticipantListener
{
public:
    Others(const std::string& commands, const std::string& odometry) : commands_(commands), odometry_(odometry) {}

    void on_publisher_discovery(fast::DomainParticipant*, rtps::WriterDiscoveryInfo&& found) override
    {
        if (found.status == rtps::WriterDiscoveryInfo::DISCOVERED_WRITER && commands_ == found.info.topicName().c_str())
        {
            tell("writer", found.info);
        }
    }

    void on_subscriber_discovery(fast::DomainParticipant*, rtps::ReaderDiscoveryInfo&& found) override
    {
        if (found.status == rtps::ReaderDiscoveryInfo::DISCOVERED_READER && odometry_ == found.info.topicName().c_str())
        {
            tell("reader", found.info);
        }
    }

private:
    template <typename Endpoint>
    static void tell(const char* kind, const Endpoint& endpoint)
    {
        const std::vector<rtps::octet>& data = endpoint.m_qos.m_userData.data_vec();
        const bool reliable = endpoint.m_qos.m_reliability.kind == fast::RELIABLE_RELIABILITY_QOS;
        say(std::string("{\"") + kind + "\": " + quoted(endpoint.topicName().c_str()) + ", \"type\": " +
            quoted(endpoint.typeName().c_str()) + ", \"user_data\": " + quoted(std::string(data.begin(), data.end())) +
            ", \"reliable\": " + (reliable ? "true" : "false") + "}");
    }

    const std::string commands_, odometry_;
};

static fast::DomainParticipantQos on_this_pc_only(int domain)
{
    fast::DomainParticipantQos qos;
    qos.name("pioneer");
    auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.push_back("127.0.0.1");
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(udp);
    for (int participant = 0; participant < PARTICIPANTS; ++participant)
    {
        rtps::Locator_t locator;
        rtps::IPLocator::setIPv4(locator, 127, 0, 0, 1);
        locator.port = uint32_t(7400 + 250 * domain + 10 + 2 * participant);  // OMG DDSI-RTPS 9.6.2
        qos.wire_protocol().builtin.initialPeersList.push_back(locator);
    }
    return qos;
}

static void set_user_data(fast::UserDataQosPolicy& policy, const char* text)
{
    policy.data_vec(std::vector<rtps::octet>(text, text + std::strlen(text)));
}

template <typename Message>
static fast::DataReader* listen(fast::DomainParticipant* participant, const char* topic, const char* user_data, Robot& robot)
{
    fast::TypeSupport type(new RosType<Message>());
    type.register_type(participant);
    fast::DataReaderQos qos;
    qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
    qos.history().depth = 10;
    qos.data_sharing().off();
    set_user_data(qos.user_data(), user_data);
    return participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT)->create_datareader(
        participant->create_topic(topic, type.get_type_name(), fast::TOPIC_QOS_DEFAULT), qos, new Commands<Message>(robot));
}

static fast::DataWriter* announce(fast::DomainParticipant* participant, const char* topic, const char* user_data)
{
    fast::TypeSupport type(new RosType<Odometry>());
    type.register_type(participant);
    fast::DataWriterQos qos;
    qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
    qos.history().depth = 10;
    qos.data_sharing().off();
    set_user_data(qos.user_data(), user_data);
    return participant->create_publisher(fast::PUBLISHER_QOS_DEFAULT)->create_datawriter(
        participant->create_topic(topic, type.get_type_name(), fast::TOPIC_QOS_DEFAULT), qos);
}

static void drive(Robot& robot, fast::DataWriter* writer, const std::atomic<bool>& is_mute)
{
    timespec next;
    clock_gettime(CLOCK_MONOTONIC, &next);
    while (true)
    {
        Odometry odometry = robot.report();
        if (!is_mute)
        {
            writer->write(&odometry);
        }
        next.tv_nsec += long(PERIOD_S * 1e9);
        next.tv_sec += next.tv_nsec / 1000000000;
        next.tv_nsec %= 1000000000;
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
    }
}

int main(int argc, char** argv)
{
    if (argc != 5 && argc != 7)
    {
        std::fprintf(stderr, "usage: peer DOMAIN COMMAND_TOPIC ODOMETRY_TOPIC twist|twist_stamped "
                             "[COMMAND_USER_DATA ODOMETRY_USER_DATA]\n");
        return 2;
    }
    const int domain = std::atoi(argv[1]);
    const bool is_stamped = std::strcmp(argv[4], "twist_stamped") == 0;
    const char* user_data[] = {argc == 7 ? argv[5] : "", argc == 7 ? argv[6] : ""};
    static Others others(argv[2], argv[3]);
    static Robot robot;
    static std::atomic<bool> is_mute(false);
    fast::DomainParticipant* participant = fast::DomainParticipantFactory::get_instance()->create_participant(
        domain, on_this_pc_only(domain), &others, fast::StatusMask::none());
    if (participant == nullptr)
    {
        std::fprintf(stderr, "no participant in domain %d\n", domain);
        return 1;
    }
    fast::DataReader* reader = is_stamped ? listen<TwistStamped>(participant, argv[2], user_data[0], robot)
                                         : listen<Twist>(participant, argv[2], user_data[0], robot);
    fast::DataWriter* writer = announce(participant, argv[3], user_data[1]);
    if (reader == nullptr || writer == nullptr)
    {
        std::fprintf(stderr, "no endpoints\n");
        return 1;
    }
    say("{\"ready\": true}");
    std::thread(drive, std::ref(robot), writer, std::cref(is_mute)).detach();
    char word[32];
    while (std::fgets(word, sizeof word, stdin) != nullptr)
    {
        is_mute = std::strcmp(word, "mute\n") == 0;
    }
    std::fflush(stdout);
    _exit(0);  // as a robot that is switched off: threads of the library still run
}
