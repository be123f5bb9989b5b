// The ROS 2 messages of the robot, written from the .msg files of geometry_msgs and nav_msgs, as Fast DDS types.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>

using eprosima::fastcdr::Cdr;

struct Header
{
    int32_t sec = 0;
    uint32_t nanosec = 0;
    std::string frame_id;

    void write(Cdr& cdr) const { cdr << sec << nanosec << frame_id; }
    void read(Cdr& cdr) { cdr >> sec >> nanosec >> frame_id; }
};

struct Twist
{
    static constexpr const char* type_name = "geometry_msgs::msg::dds_::Twist_";

    std::array<double, 3> linear{};
    std::array<double, 3> angular{};

    void write(Cdr& cdr) const { cdr << linear << angular; }
    void read(Cdr& cdr) { cdr >> linear >> angular; }
};

struct TwistStamped
{
    static constexpr const char* type_name = "geometry_msgs::msg::dds_::TwistStamped_";

    Header header;
    Twist twist;

    void write(Cdr& cdr) const { header.write(cdr); twist.write(cdr); }
    void read(Cdr& cdr) { header.read(cdr); twist.read(cdr); }
};

struct Odometry
{
    static constexpr const char* type_name = "nav_msgs::msg::dds_::Odometry_";

    Header header;
    std::string child_frame_id;
    std::array<double, 3> position{};
    std::array<double, 4> orientation{};  // x, y, z, w
    std::array<double, 36> pose_covariance{};
    Twist twist;
    std::array<double, 36> twist_covariance{};

    void write(Cdr& cdr) const
    {
        header.write(cdr);
        cdr << child_frame_id << position << orientation << pose_covariance;
        twist.write(cdr);
        cdr << twist_covariance;
    }

    void read(Cdr& cdr)
    {
        header.read(cdr);
        cdr >> child_frame_id >> position >> orientation >> pose_covariance;
        twist.read(cdr);
        cdr >> twist_covariance;
    }
};

// A message without key, in plain CDR (XCDR1), as ROS 2 sends it.
template <typename Message>
class RosType : public eprosima::fastdds::dds::TopicDataType
{
public:
    using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

    RosType()
    {
        setName(Message::type_name);
        m_typeSize = 2048;  // bytes, far more than the messages here with their frame names
        m_isGetKeyDefined = false;
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }

    bool serialize(void* data, Payload* payload) override
    {
        eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
        Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
        payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
        cdr.serialize_encapsulation();
        static_cast<const Message*>(data)->write(cdr);
        payload->length = static_cast<uint32_t>(cdr.getSerializedDataLength());
        return true;
    }

    bool deserialize(Payload* payload, void* data) override
    {
        try
        {
            eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
            Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
            cdr.read_encapsulation();
            static_cast<Message*>(data)->read(cdr);
            return true;
        }
        catch (const eprosima::fastcdr::exception::Exception&)
        {
            return false;
        }
    }

    std::function<uint32_t()> getSerializedSizeProvider(void*) override
    {
        return [this]() { return m_typeSize; };
    }

    void* createData() override { return new Message(); }
    void deleteData(void* data) override { delete static_cast<Message*>(data); }
    bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};
